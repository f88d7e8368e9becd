// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/text_file.h"

#include "core/base/file_writer.h"

#include <QFile>

#include <span>

namespace tetra {
namespace {

constexpr qint64 largestFile = 64 << 20; // a session with a long film has some megabytes

} // namespace

Result<std::string> readTextFile(const std::filesystem::path& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{
            file.error() == QFileDevice::ResourceError ? ErrorKind::OutOfResource : ErrorKind::BadInput,
            Message::say("The file '%1' cannot be read: %2.", path.string(), file.errorString().toStdString())};
    const QByteArray bytes = file.read(largestFile + 1);
    if (bytes.size() > largestFile)
        return Error{ErrorKind::BadInput,
                     Message::say("The file '%1' is too large to be what is looked for here.", path.string())};
    return bytes.toStdString();
}

Status writeTextFile(const std::filesystem::path& path, std::string_view text)
{
    return writeWholeFile(path, std::as_bytes(std::span(text)));
}

} // namespace tetra
