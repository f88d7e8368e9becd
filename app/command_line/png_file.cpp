// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/png_file.h"

#include "core/base/file_writer.h"

#include <QBuffer>
#include <QByteArray>
#include <QImage>

#include <span>

namespace tetra {

Status writePng(const std::filesystem::path& path, const Picture& picture)
{
    return writePng(path, QImage(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                                 QImage::Format_RGBA8888));
}

Status writePng(const std::filesystem::path& path, const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG"))
        return Error{ErrorKind::OutOfResource,
                     "The picture cannot be coded as PNG: too large for this machine's memory?"};
    return writeWholeFile(path, std::as_bytes(std::span(bytes.constData(), bytes.size())));
}

} // namespace tetra
