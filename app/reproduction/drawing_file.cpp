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

std::span<const std::byte> contentOf(const QByteArray& bytes)
{
    return std::as_bytes(std::span(bytes.constData(), bytes.size()));
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
    return writeWholeFile(path, contentOf(bytes));
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
    return writeWholeFile(path, contentOf(bytes));
}

Result<std::vector<std::filesystem::path>> writeDrawing(const std::filesystem::path& file, const QSizeF& size,
                                                        const Drawing& drawing)
{
    std::filesystem::path png = file, svg = file;
    png += ".png";
    svg += ".svg";
    for (const Status& written : {writeDrawingAsPng(png, size, drawing), writeDrawingAsSvg(svg, size, drawing)})
        if (!written)
            return written.error();
    return std::vector{png, svg};
}

} // namespace tetra
