// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/recent_files.h"

#include "ui/opening/sample_models.h"
#include "ui/session/files.h"

#include <tan/open.h>

#include <QFileInfo>
#include <QSettings>

namespace tetra {
namespace {

constexpr qsizetype mostRecentFiles = 10;
constexpr const char* recentFilesKey = "recentFiles";

} // namespace

QStringList recentFiles()
{
    QStringList files = QSettings().value(recentFilesKey).toStringList();
    files.removeIf([](const QString& path) {
        return !isAddress(path.toStdString()) && (isOfSample(filePath(path)) || !QFileInfo::exists(path));
    });
    return files;
}

void addRecentFile(const QString& path)
{
    const bool isRemote = isAddress(path.toStdString());
    const QString absolute = isRemote ? path : QFileInfo(path).absoluteFilePath();
    if (!isRemote && isOfSample(filePath(absolute)))
        return;
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    QSettings().setValue(recentFilesKey, files.mid(0, mostRecentFiles));
}

void forgetRecentFiles()
{
    QSettings().remove(recentFilesKey);
}

} // namespace tetra
