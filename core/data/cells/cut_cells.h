// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/cells/cell_split.h"
#include "core/data/cells/clean_cells.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace tetra {

/// New pieces of some cells.
struct ResplitCells {
    std::map<std::uint32_t, CellPieces> pieces; ///< by cell: those that the rule of splitCell() failed on that have a
                                                ///< cut after all, and neighbours that followed a turned diagonal
    std::vector<std::uint32_t> warped;          ///< those that have none
};

/// Looks for other cuts of `failing` cells, sorted: first inside, then with diagonals of their quadrilateral faces
/// turned, as few as possible, as long as the cells beyond these faces still have a cut. Greedy: each cell that was
/// repaired stays repaired. O(cells) to find the neighbours; the search ends after a million steps, and what is not
/// repaired then counts as warped. So does what is left when it is cancelled.
ResplitCells resplitCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells,
                          const std::vector<std::uint32_t>& failing, const Progress& progress);

/// Positive tetrahedra, and which of the prepared cells each comes from.
struct CutCells {
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> warped; ///< cells that have no cut into positive tetrahedra
};

/// Cuts every cell by the rule of splitCell(), turning over what is negative; a cell in which that gives tetrahedra
/// of either sign, as faces that are not flat do, gets another inside, or other diagonals on faces where the neighbour
/// can follow. Cells without volume are left out. `repairs` is told. Errors: OutOfResource for more tetrahedra than
/// the program can number; cancelled. Linear in the cells but for those few.
Result<CutCells> cutCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, Repairs& repairs,
                          const Progress& progress);

} // namespace tetra
