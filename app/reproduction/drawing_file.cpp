// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/drawing_file.h"

#include "core/base/file_writer.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>

#include <span>

namespace tetra {

namespace {

constexpr int pixelsPerUnit = 2;

Status writeBytes(const std::filesystem::path& path, const QByteArray& bytes)
{
    auto file = FileWriter::create(path);
    if (!file)
        return file.error();
    if (const Status written = file->write(std::as_bytes(std::span(bytes.constData(), bytes.size()))); !written)
        return written;
    return file->commit();
}

} // namespace

Status writeDrawingAsPng(const std::filesystem::path& path, const QSizeF& size, const Drawing& drawing)
{
    QImage image((size * pixelsPerUnit).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelsPerUnit);
    image.fill(Qt::white);
    {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        drawing(painter);
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG"))
        return Error{ErrorKind::OutOfResource, "Not enough memory to draw '" + path.string() + "'."};
    return writeBytes(path, bytes);
}

Status writeDrawingAsSvg(const std::filesystem::path& path, const QSizeF& size, const Drawing& drawing)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size.toSize());
    generator.setViewBox(QRectF({0, 0}, size));
    {
        QPainter painter(&generator);
        drawing(painter);
    }
    return writeBytes(path, bytes);
}

} // namespace tetra
