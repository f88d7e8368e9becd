// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/sample_box.h"

namespace tetra {
namespace {

/// The smallest rectangle around images, in samples.
struct ImageBounds {
    double low[2] = {1e30, 1e30};
    double high[2] = {-1e30, -1e30};

    void include(const VolumeView& view, double u, double v, double w)
    {
        const double place[2] = {u / w - view.firstX(), v / w - view.firstY()};
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], place[axis]);
            high[axis] = std::max(high[axis], place[axis]);
        }
    }
};

} // namespace

SampleRectangle boxOfCutCorners(std::span<const std::uint32_t> corners, const ProjectedVertices& projected,
                                const VolumeView& view)
{
    ImageBounds bounds;
    bool seen = false;
    for (const std::uint32_t corner : corners) {
        const ProjectedVertex& a = projected.vertices[corner];
        if (!(a.w > view.nearest))
            continue;
        seen = true;
        bounds.include(view, a.u, a.v, a.w);
        for (const std::uint32_t other : corners) {
            const ProjectedVertex& b = projected.vertices[other];
            if (b.w > view.nearest)
                continue;
            const double share = (a.w - view.nearest) / (double(a.w) - b.w);
            bounds.include(view, a.u + share * (double(b.u) - a.u), a.v + share * (double(b.v) - a.v), view.nearest);
        }
    }
    if (!seen)
        return {};
    // One more on each side, as these are the places of rounded vertices.
    return {firstSampleFrom(bounds.low[0]) - 1, firstSampleFrom(bounds.low[1]) - 1, firstSampleFrom(bounds.high[0]) + 1,
            firstSampleFrom(bounds.high[1]) + 1};
}

} // namespace tetra
