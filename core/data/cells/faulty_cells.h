// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/clean_cells.h"
#include "core/data/cells/cut_cells.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <string>

namespace tetra {

/// Takes out the cells of which tetrahedra are there twice, but for one, and those that overlap others (C10): so many
/// that no two overlap, of the rest first the one that overlaps the most. `repairs` is told. Error: BadInput if more
/// than the share `mostFaulty` of the cells, and of the volume, would have to go because of overlaps; cancelled.
/// Positive tetrahedra; findOverlaps() for each layer of cells that is taken out, three or four at most.
/// `cellCount`: of how many cells `cut` is.
Status takeOutFaulty(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, std::uint64_t cellCount,
                     double mostFaulty, CutCells& cut, Repairs& repairs, const Progress& progress);

/// "0.1%": a share, as the option for it takes it.
std::string shareText(double share);

/// The next share that is worth asking for, of those that are larger than `mostFaulty` and let so many cells be taken
/// out.
std::string largerShareText(double mostFaulty, std::uint64_t faultyCount, std::uint64_t cellCount);

} // namespace tetra
