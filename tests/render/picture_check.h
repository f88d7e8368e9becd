// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <QDir>
#include <QImage>
#include <QString>

#include <algorithm>
#include <cstdlib>

namespace tetra::testing {

/// Keeps a picture in the build folder, for a look at what failed; returns where.
inline QString savePicture(const Picture& picture, const QString& name)
{
    const QDir folder(QStringLiteral(TAN_BINARY_DIR) + "/tests/pictures");
    folder.mkpath(".");
    const QImage image(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                       QImage::Format_RGBA8888);
    const QString path = folder.filePath(name + ".png");
    return image.save(path) ? path : "(could not write " + path + ")";
}

/// By the CPU back end, which is the reference.
inline Picture renderedByCpu(const Scene& scene, const Camera& camera, const PictureOptions& options)
{
    auto picture = makeCpuBackend()->render(scene, camera, options);
    if (!picture)
        qFatal("%s", picture.error().text().c_str());
    return *std::move(picture);
}

inline const std::array<std::uint8_t, 4>& pixelAt(const Picture& picture, int x, int y)
{
    return picture
        .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)];
}

/// The largest difference in a channel.
inline int difference(const std::array<std::uint8_t, 4>& one, const std::array<std::uint8_t, 4>& other)
{
    int largest = 0;
    for (std::size_t channel = 0; channel < one.size(); ++channel)
        largest = std::max(largest, std::abs(one[channel] - other[channel]));
    return largest;
}

} // namespace tetra::testing
