// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/cells/cell_split.h"
#include "core/cells/prepared_cells.h"

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace tetra {

/// New pieces of some cells.
struct RecutCells {
    std::map<std::uint32_t, CellPieces> pieces; ///< by cell: those that the rule of splitCell() failed on that have a
                                                ///< cut after all, and neighbours that followed a turned diagonal
    std::vector<std::uint32_t> warped;          ///< those that have none
};

/// Looks for other cuts of `failing` cells, sorted: first inside, then with diagonals of their quadrilateral faces
/// turned, as few as possible, as long as the cells beyond these faces still have a cut. Greedy: each cell that was
/// mended stays mended. O(cells) to find the neighbours; the search ends after a million steps, and what is not mended
/// then counts as warped. So does what is left when it is cancelled.
RecutCells recutCells(std::span<const Eigen::Vector3d> positions, const PreparedCells& cells,
                      const std::vector<std::uint32_t>& failing, const Progress& progress);

} // namespace tetra
