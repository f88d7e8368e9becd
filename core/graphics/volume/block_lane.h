// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/tile_picture.h"

namespace tetra {

/// Where a sample of a tile is kept: in which of its blocks, and in which lane of that.
struct BlockLane {
    std::size_t block;
    std::size_t lane;

    BlockLane(int x, int y)
        : block(static_cast<std::size_t>(y / blockHeight * (volumeTileSide / blockWidth) + x / blockWidth)),
          lane(static_cast<std::size_t>(y % blockHeight * blockWidth + x % blockWidth))
    {
    }
};

} // namespace tetra
