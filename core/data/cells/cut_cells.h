// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/clean_cells.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Positive tetrahedra, and which of the prepared cells each comes from.
struct CutCells {
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> warped;      ///< cells that have no cut into positive tetrahedra
    std::vector<std::uint32_t> open;        ///< polyhedra whose faces do not close
    std::vector<Eigen::Vector3d> centres;   ///< points in the middle of polyhedra, numbered after the mesh's own
    std::vector<std::uint32_t> centreCells; ///< of each of these, ascending
};

/// Cuts every cell by the rule of splitCell(), turning over what is negative; a cell in which that gives tetrahedra
/// of either sign, as faces that are not flat do, gets another inside, or other diagonals on faces where the neighbour
/// can follow. Polyhedra as in polyhedron.h, with a point in the middle if `addsCentres` and nothing else cuts them.
/// Cells without volume are left out. `repairs` is told. Errors: OutOfResource for more tetrahedra than
/// the program can number; cancelled. Linear in the cells but for those few.
Result<CutCells> cutCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, bool addsCentres,
                          Repairs& repairs, const Progress& progress);

} // namespace tetra
