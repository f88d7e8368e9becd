// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/picture_file.h"

#include "core/base/file_writer.h"
#include "ui/session/picture_image.h"

#include <QBuffer>

#include <cmath>

namespace tetra {
namespace {

constexpr double inchesPerMetre = 1 / 0.0254;

Scene withLines(Scene scene, double scale)
{
    for (LineSet& lines : scene.lines)
        lines.width = static_cast<float>(lines.width * scale);
    return scene;
}

} // namespace

Result<Picture> drawScene(const PictureOrder& order, RenderBackend& backend, bool withDepth, const Progress& progress)
{
    PictureOptions options;
    options.width = order.width;
    options.height = order.height;
    options.background = order.background;
    options.transparentBackground = order.transparent;
    options.samplesPerAxis = order.samplesPerAxis;
    options.threads = order.threads;
    options.depth = withDepth;
    const Scene scene = withLines(order.scene ? *order.scene : Scene(), order.lineScale);
    return backend.render(scene, order.camera, options, progress);
}

QImage finishedPicture(const PictureOrder& order, const Picture& picture)
{
    QImage image = imageOf(picture);
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

Result<QImage> drawPicture(const PictureOrder& order, const Progress& progress)
{
    const auto picture = drawScene(order, *makeCpuBackend(), false, progress);
    if (!picture)
        return picture.error();
    return finishedPicture(order, *picture);
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
