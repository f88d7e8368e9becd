// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/focus_rays.h"
#include "core/graphics/volume/volume_tile.h"

#include <span>
#include <vector>

namespace tetra {

/// FocusRays::Passage of the rays of a block.
struct alignas(64) BlockPassage {
    Float8 enter, in, out, leave;
};

/// What a ray of a tile gathers on a short way through the border of a focus, as if it were a surface in the middle of
/// that way.
struct BorderFragment {
    std::uint32_t sample; ///< of the tile, row by row
    SurfaceFragment surface;
};

/// The blocks of a tile that a focus is drawn in.
struct BorderTile {
    const FocusRays* rays = nullptr;
    SampleRectangle tile;
    std::span<const BlockPassage> passages; ///< for each block
    std::span<const SampleBlock> blocks;
    int columns = 0; ///< blocks a row
    const ScaledSegment* segments = nullptr;
    bool perspective = true;
};

/// Adds what `cells` show in the border, weighted as those of the fine volume or of the other, in no order: the ways
/// are no longer than a cell and a quarter of the border, so that cells of both volumes may be drawn one after the
/// other where they lie in the same place.
void collectBorder(std::span<const CellSetup> cells, bool fine, const BorderTile& tile,
                   std::vector<BorderFragment>& fragments);

} // namespace tetra
