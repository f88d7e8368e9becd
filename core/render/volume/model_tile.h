// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_tile.h"

#include <tan/render.h>

#include <cstddef>
#include <span>

namespace tetra {

/// The optical model of a volume, and how the scaled values and lengths of cells (ScaledSegments, VolumeView) become
/// the numbers that it is given.
struct TileModel {
    const OpticalModel* optics = nullptr;
    double smallest = 0; ///< of ScaledSegments, like the next
    double perValue = 1;
    double unit = 1; ///< of VolumeView
};

/// What a block's rays have gathered so far by a model whose combiner is not Over.
struct alignas(64) BlockTotal {
    Float8 red, green, blue, opacity;
};

/// drawCells() with shading.model, which is given the pieces of rays in many blocks at a time. If its combiner is Over
/// the light goes into the blocks, with that of the surfaces; else it goes into `totals`, one for each block, and
/// surfaces are not looked at. May throw what the model throws.
std::size_t drawCellsByModel(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                             BlockTotal* totals, int columns);

} // namespace tetra
