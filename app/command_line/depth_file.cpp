// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/depth_file.h"

#include "core/base/text.h"
#include "ui/scenes/picture_file.h"

#include <QImage>

#include <algorithm>
#include <cmath>
#include <limits>

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
{
    if (picture.depth.size() != picture.pixels.size())
        return Error{ErrorKind::OutOfResource,
                     "This back end provides no depths. Leave '--depth' out, or choose another."};
    const DepthScale scale = scaleOf(picture.depth);
    QImage image(picture.width, picture.height, QImage::Format_Grayscale16);
    if (image.isNull())
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for the picture of depths. Make the picture smaller."};
    auto depth = picture.depth.begin();
    for (int row = 0; row < picture.height; ++row) {
        auto* greys = reinterpret_cast<std::uint16_t*>(image.scanLine(row));
        for (int column = 0; column < picture.width; ++column)
            greys[column] = greyOf(*depth++, scale);
    }
    image.setText("nearest", QString::fromStdString(formatNumber(scale.nearest)));
    image.setText("farthest", QString::fromStdString(formatNumber(scale.farthest)));
    if (const Status written = writePicture(image, path); !written)
        return written.error();
    return scale;
}

} // namespace tetra
