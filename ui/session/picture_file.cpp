// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/picture_file.h"

#include "core/base/file_writer.h"
#include "core/graphics/render_backend.h"
#include "ui/session/picture_image.h"

#include <QBuffer>

#include <cmath>

namespace tetra {
namespace {

/// Twice as many samples along each axis as the viewport takes: a picture to keep may take its time.
constexpr int samplesPerAxis = 4;
constexpr double inchesPerMetre = 1 / 0.0254;

Scene withLines(Scene scene, double scale)
{
    for (LineSet& lines : scene.lines)
        lines.width = static_cast<float>(lines.width * scale);
    return scene;
}

} // namespace

Result<QImage> drawPicture(const PictureOrder& order, const Progress& progress)
{
    PictureOptions options;
    options.width = order.width;
    options.height = order.height;
    options.background = order.background;
    options.transparentBackground = order.transparent;
    options.samplesPerAxis = samplesPerAxis;
    const Scene scene = withLines(order.scene ? *order.scene : Scene(), order.lineScale);
    const auto picture = makeCpuBackend()->render(scene, order.camera, options, progress);
    if (!picture)
        return picture.error();
    QImage image = imageOf(*picture);
    if (order.finish)
        order.finish(image);
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
        return Error{ErrorKind::OutOfResource, "There is not enough memory for a picture of this size."};
    const QByteArray& bytes = buffer.data();
    return writeWholeFile(target, std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size()))));
}

} // namespace tetra
