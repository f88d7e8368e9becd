// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/tiles.h"
#include "core/render/view_transform.h"
#include "core/render/volume/volume_tile.h"
#include "core/render/volume/volume_view.h"

#include <span>

namespace tetra {

/// Makes the blocks of a tile ready to be drawn into: nothing there yet, and all of the light behind comes through;
/// none in the samples that a smaller tile does not have. `blocks` are those of a whole tile (BlockLane).
void clearBlocks(const VolumeView& view, const SampleRectangle& tile, std::span<SampleBlock> blocks);

/// The samples of a tile over nothing, row by row.
void takeColours(std::span<const SampleBlock> blocks, const SampleRectangle& tile,
                 std::span<PremultipliedColour> colours);

} // namespace tetra
