// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/render/render_backend.h"
#include "core/render/scene.h"
#include "core/render/view_transform.h"
#include "core/render/volume/volume_view.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Pictures with more samples a side than this are drawn in parts, so that what is kept for the tiles at one time, and
/// the coordinates in them, stay bounded. Twice what the largest screens have.
inline constexpr int largestPartSide = 8192;

/// A picture of `width` x `height` samples in parts, row by row, whose sides but the last are multiples of `tileSide`.
std::vector<SampleRectangle> picturePartsOf(int width, int height, int tileSide);

/// A part of a picture that is to be drawn, in samples. Both views are of the part.
struct PartView {
    SampleRectangle part;
    ViewTransform surfaces;
    VolumeView volume;
};

/// Samples an axis of a tile; tiles hold whole pixels.
int tileSideFor(int samplesPerAxis);

/// The visibility orders of the scene's volume and of the fine one in its focus; empty if there is none.
struct VolumeOrders {
    std::span<const std::uint32_t> volume, fine;
};

/// Draws a part of the scene into its place in the picture: surfaces and lines by tiles, and where there are cells of
/// the volume, both together, front to back (R21). Adds to the statistics. On all threads of
/// the current arena, the same picture with any number. Errors: a scene whose indices lead nowhere, cancelled. May
/// throw std::bad_alloc.
Status drawPart(const Scene& scene, const PartView& view, const VolumeOrders& orders, const PictureOptions& options,
                const Progress& progress, Picture& picture, RenderStatistics& statistics);

} // namespace tetra
