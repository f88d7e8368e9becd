// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/picture_file.h"

#include "core/base/file_writer.h"
#include "core/graphics/render_backend.h"
#include "ui/session/picture_image.h"

#include <QBuffer>

namespace tetra {
namespace {

/// Twice as many samples along each axis as the viewport takes: a picture to keep may take its time.
constexpr int samplesPerAxis = 4;

QByteArray pngOf(const Picture& picture)
{
    QBuffer buffer;
    imageOf(picture).save(&buffer, "PNG");
    return buffer.data();
}

} // namespace

Status writePicture(const PictureOrder& order, const Progress& progress)
{
    PictureOptions options;
    options.width = order.width;
    options.height = order.height;
    options.background = order.background;
    options.samplesPerAxis = samplesPerAxis;
    const auto picture = makeCpuBackend()->render(*order.scene, order.camera, options, progress);
    if (!picture)
        return picture.error();
    const QByteArray bytes = pngOf(*picture);
    auto file = FileWriter::create(order.target);
    if (!file)
        return file.error();
    if (Status written =
            file->write(std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size()))));
        !written)
        return written;
    return file->commit();
}

} // namespace tetra
