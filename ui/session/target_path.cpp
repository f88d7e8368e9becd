// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/target_path.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace tetra {

std::filesystem::path filePath(const QString& path)
{
    return QFile::encodeName(path).toStdString();
}

QString pathText(const std::filesystem::path& path)
{
    return QFile::decodeName(QByteArray::fromStdString(path.native()));
}

QString documentFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

QString proposedModelPath(const std::filesystem::path& dataset)
{
    const QFileInfo file(pathText(dataset));
    const QString folder = QFileInfo(file.absolutePath()).isWritable() ? file.absolutePath() : documentFolder();
    const QString name = file.completeBaseName().isEmpty() ? QString("model") : file.completeBaseName();
    return folder + "/" + name + ".tan";
}

} // namespace tetra
