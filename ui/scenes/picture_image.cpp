// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scenes/picture_image.h"

#include <cstring>

namespace tetra {

QImage imageOf(const Picture& picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGBA8888);
    if (image.isNull()) // not enough memory
        return image;
    const std::size_t rowBytes = static_cast<std::size_t>(picture.width) * 4;
    for (int row = 0; row < picture.height; ++row)
        std::memcpy(image.scanLine(row), picture.pixels.data() + static_cast<std::size_t>(row) * picture.width,
                    rowBytes);
    return image;
}

} // namespace tetra
