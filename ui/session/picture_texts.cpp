// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/picture_texts.h"

#include "ui/session/target_path.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>
#include <QJsonDocument>

namespace tetra {
namespace {

const QString& sessionKey()
{
    static const QString key = "TAn-session"; // with a blank Qt would not find it
    return key;
}

/// On one line, and without two blanks side by side: Qt makes one of them when it reads.
QString oneLine(const std::string& json)
{
    QString text = QJsonDocument::fromJson(QByteArray::fromStdString(json)).toJson(QJsonDocument::Compact);
    return text.replace("  ", " \\u0020");
}

} // namespace

std::map<QString, QString> pictureTexts(const SessionDocument& document, const QString& accuracy,
                                        const std::filesystem::path& folder)
{
    return {{"Software", QString("TAn %1").arg(QCoreApplication::applicationVersion())},
            {"Title", QFileInfo(pathText(document.model)).completeBaseName()},
            {"Description", accuracy},
            {sessionKey(), oneLine(sessionToText(document, folder))}};
}

std::string sessionInPicture(const std::filesystem::path& path)
{
    QImageReader reader(pathText(path), "png");
    return reader.text(sessionKey()).toStdString();
}

bool isPictureFile(const std::filesystem::path& path)
{
    return QFileInfo(pathText(path)).suffix().compare("png", Qt::CaseInsensitive) == 0;
}

} // namespace tetra
