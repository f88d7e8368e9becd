// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/depth_file.h"

#include "core/base/file_writer.h"
#include "core/picture/png_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace tetra {
namespace {

constexpr double farthestGrey = 65534;
constexpr std::uint16_t nothing = 65535;

DepthScale scaleOf(const std::vector<float>& depths)
{
    DepthScale scale{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double depth : depths)
        if (std::isfinite(depth)) {
            scale.nearest = std::min(scale.nearest, depth);
            scale.farthest = std::max(scale.farthest, depth);
        }
    return scale.nearest <= scale.farthest ? scale : DepthScale{};
}

std::uint16_t greyOf(double depth, const DepthScale& scale)
{
    if (!std::isfinite(depth))
        return nothing;
    const double extent = scale.farthest - scale.nearest;
    return extent > 0 ? static_cast<std::uint16_t>(std::lround((depth - scale.nearest) / extent * farthestGrey)) : 0;
}

} // namespace

Result<DepthScale> writeDepth(const std::filesystem::path& path, const Picture& picture)
try {
    if (picture.depth.size() != picture.pixels.size())
        return Error{ErrorKind::OutOfResource,
                     "This back end provides no depths. Leave '--depth' out, or choose another."};
    const DepthScale scale = scaleOf(picture.depth);
    std::vector<std::uint16_t> greys(picture.depth.size());
    std::ranges::transform(picture.depth, greys.begin(), [&](float depth) { return greyOf(depth, scale); });
    const auto file =
        pngOfGreys(greys, picture.width, picture.height,
                   {.texts = {{"nearest", formatNumber(scale.nearest)}, {"farthest", formatNumber(scale.farthest)}}});
    if (!file)
        return file.error();
    if (const Status written = writeWholeFile(path, *file); !written)
        return written.error();
    return scale;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory for the picture of depths. Make the picture smaller."};
}

} // namespace tetra
