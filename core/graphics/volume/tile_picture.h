// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/graphics/cpu/tile_bins.h"
#include "core/graphics/volume/volume_renderer.h"
#include "core/graphics/volume/volume_tile.h"
#include "core/graphics/volume/volume_view.h"

#include <span>
#include <vector>

namespace tetra {

/// Samples a side of a tile: its blocks, 48 bytes a sample, fit the second-level cache many times, and few cells lie in
/// more than one tile.
inline constexpr int volumeTileSide = 64;

/// Draws tile after tile into a picture, in memory of its own; one object a thread.
class VolumeTilePainter {
public:
    VolumeTilePainter(const SetupSource& source, const VolumeView& view);

    /// `cells` front to back. Writes the tile's part of the picture; of the depth if it has one. Returns how many cells
    /// were drawn before all was opaque. Incomplete if cancelled. May throw std::bad_alloc.
    std::size_t paint(const SampleRectangle& tile, std::span<const BinnedCell> cells, const Progress& progress,
                      VolumePicture& picture);

private:
    void clear(const SampleRectangle& tile);
    bool allDark();
    void write(const SampleRectangle& tile, VolumePicture& picture) const;

    const SetupSource& source_;
    const VolumeView& view_;
    std::vector<SampleBlock> blocks_;
    std::vector<CellSetup> setups_;
    std::size_t firstLit_ = 0; ///< all blocks before it are opaque
};

} // namespace tetra
