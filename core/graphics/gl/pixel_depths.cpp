// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/pixel_depths.h"

#include "core/graphics/resolve.h"

#include <algorithm>
#include <limits>

namespace tetra {
namespace {

/// The distance from the eye along the view's axis.
float distanceOfDepth(float depth, const Eigen::Matrix4d& projection, bool perspective)
{
    if (!(depth < 1))
        return std::numeric_limits<float>::infinity();
    const double clip = 2.0 * depth - 1;
    const double a = projection(2, 2), b = projection(2, 3);
    return static_cast<float>(perspective ? b / (clip + a) : (b - clip) / a);
}

} // namespace

std::vector<float> pixelDepths(std::span<float> samples, const SampleView& view, int samplesPerAxis)
{
    const double aspectRatio = static_cast<double>(view.width) / view.height;
    const Eigen::Matrix4d projection = projectionMatrix(view.camera, aspectRatio, view.bounds);
    for (float& sample : samples)
        sample = distanceOfDepth(sample, projection, view.camera.perspective);
    for (auto first = samples.begin(), last = samples.end(); last - first > view.width; first += view.width) {
        last -= view.width;
        std::swap_ranges(first, first + view.width, last);
    }
    Picture picture{view.width / samplesPerAxis, view.height / samplesPerAxis, {}};
    picture.depth.resize(samples.size() / static_cast<std::size_t>(samplesPerAxis * samplesPerAxis));
    resolveDepth(samples, view.width, samplesPerAxis, 0, 0, picture);
    return picture.depth;
}

} // namespace tetra
