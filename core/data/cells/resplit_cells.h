// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_split.h"
#include "core/data/cells/clean_cells.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace tetra {

/// A quadrilateral by its nodes, ascending.
using FaceKey = std::array<std::uint32_t, 4>;
FaceKey faceKey(const CellPolygon& quadrilateral);

/// Of any prepared cell.
std::vector<CellPolygon> quadrilateralsOf(const CleanCells& cells, std::uint32_t cell);

/// Points in the middle of polyhedra, numbered after those of the mesh.
struct CellCentres {
    std::vector<Eigen::Vector3d> places;
    std::map<std::uint32_t, std::uint32_t> numbers; ///< of the point, by the prepared cell
};

/// Positive tetrahedra between the corners of a polyhedron that end on its surface: from a corner, or what fillCavity()
/// finds.
std::optional<CellPieces> cutAlone(std::span<const Eigen::Vector3d> positions, std::span<const std::uint32_t> corners,
                                   const CellSurface& surface, std::uint64_t& stepsLeft);

/// New pieces of some cells.
struct ResplitCells {
    std::map<std::uint32_t, CellPieces> pieces; ///< by cell: those that failed and have a cut after all, and neighbours
                                                ///< that followed a turned diagonal
    std::vector<std::uint32_t> warped;          ///< those that have none
};

/// Looks for other cuts of `failing` cells, sorted: first inside, then with diagonals of their quadrilateral faces
/// turned, as few as possible, as long as the cells beyond these faces still have a cut. `turned` are the faces that
/// have the other diagonal to begin with. Greedy: each cell that was repaired stays repaired. O(cells) to find the
/// neighbours; the search ends after a million steps, and what is not repaired then counts as warped. So does what is
/// left when it is cancelled.
ResplitCells resplitCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells,
                          const std::vector<std::uint32_t>& failing, const std::set<FaceKey>& turned,
                          const CellCentres& centres, const Progress& progress);

} // namespace tetra
