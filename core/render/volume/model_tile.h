// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_tile.h"

#include <tan/render.h>

#include <cstddef>
#include <span>

namespace tetra {

/// An optical model of somebody's own (OpticalModel), and from what scaled values and lengths (ScaledSegments,
/// VolumeView) its numbers come.
struct TileModel {
    const OpticalModel* optics = nullptr;
    double smallest = 0; ///< of ScaledSegments, like the next
    double perValue = 1;
    double unit = 1; ///< of VolumeView
};

/// What a block's rays have gathered so far of a model whose pieces are not put over each other.
struct alignas(64) BlockTotal {
    Float8 red, green, blue, opacity;
};

/// drawCells() with shading.model: the pieces of rays in many blocks are handed to the model at a time. Of a model that
/// is put over what lies behind the light goes into the blocks; of another one into `totals`, one for each block, and
/// surfaces are none of its business. May throw what the model throws.
std::size_t drawCellsByModel(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                             BlockTotal* totals, int columns);

} // namespace tetra
