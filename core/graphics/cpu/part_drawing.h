// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/render_backend.h"
#include "core/graphics/sample_rectangle.h"
#include "core/graphics/scene.h"
#include "core/graphics/view_transform.h"
#include "core/graphics/volume/volume_view.h"

#include <cstdint>
#include <span>

namespace tetra {

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
