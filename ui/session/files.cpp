// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/files.h"

#include "core/remote/remote_file.h"
#include "ui/session/message_text.h"

#include <tan/open.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

namespace tetra {
namespace {

class PlaceTexts {
    Q_DECLARE_TR_FUNCTIONS(Places)
};

constexpr qsizetype longestArrayName = 60;

} // namespace

std::filesystem::path filePath(const QString& path)
{
    return QFile::encodeName(path).toStdString();
}

QString pathText(const std::filesystem::path& path)
{
    return QFile::decodeName(QByteArray::fromStdString(path.native()));
}

QString shownPlace(const std::filesystem::path& place)
{
    const std::string text = place.string();
    return isAddress(text) ? QString::fromStdString(shownAddress(placeOf(text, false))) : shownText(text);
}

QString shownName(const std::filesystem::path& place)
{
    const QString name = shownText(QFileInfo(shownPlace(place)).fileName().toStdString());
    return isLeftAtServer(place.string()) ? PlaceTexts::tr("%1, at its server").arg(name) : name;
}

QString sizeText(std::uint64_t bytes)
{
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

QString documentFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

QString proposedModelPath(const std::filesystem::path& dataset, const std::string& array)
{
    const QFileInfo file(pathText(dataset));
    const QString folder = QFileInfo(file.absolutePath()).isWritable() ? file.absolutePath() : documentFolder();
    const QString name = file.completeBaseName().isEmpty() ? QString("model") : file.completeBaseName();
    QString ofArray = array.empty() ? QString() : "-" + shownText(array);
    for (QChar& character : ofArray)
        if (!character.isLetterOrNumber() && !QString("-_.+()").contains(character))
            character = '_';
    return folder + "/" + name + ofArray.left(longestArrayName) + ".tan";
}

} // namespace tetra
