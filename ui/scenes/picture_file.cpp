// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scenes/picture_file.h"

#include "core/base/file_writer.h"

#include <QBuffer>

#include <cmath>
#include <cstring>

namespace tetra {
namespace {

constexpr double inchesPerMetre = 1 / 0.0254;

} // namespace

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

Result<QImage> finishedPicture(const PictureOrder& order, Picture picture, const std::optional<DrawnLens>& lens)
{
    if (lens)
        if (const Status painted =
                paintLens(pixelsOf(picture), *lens, order.background, order.lineScale, order.lensWriting);
            !painted)
            return painted.error();
    if (order.finish)
        if (const Status painted = order.finish(picture); !painted)
            return painted.error();
    QImage image = imageOf(picture);
    if (!order.transparent)
        image = image.convertToFormat(QImage::Format_RGB32);
    if (order.dotsPerInch > 0) {
        image.setDotsPerMeterX(static_cast<int>(std::lround(order.dotsPerInch * inchesPerMetre)));
        image.setDotsPerMeterY(image.dotsPerMeterX());
    }
    for (const auto& [key, text] : order.texts)
        image.setText(key, text);
    return image;
}

Status writePicture(const QImage& picture, const std::filesystem::path& target)
{
    QBuffer buffer;
    if (!picture.save(&buffer, "PNG"))
        return Error{ErrorKind::OutOfResource, Message::say("There is not enough memory for a picture of this size.")};
    const QByteArray& bytes = buffer.data();
    return writeWholeFile(target, std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size()))));
}

} // namespace tetra
