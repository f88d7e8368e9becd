// SPDX-License-Identifier: GPL-3.0-or-later
// tan-torture-writes write FOLDER: writes a session and settings into the folder until it is killed. ... check FOLDER:
// whether what is there is whole, and whether nothing else is left once both have been written again.
#include "core/picture/session_document.h"
#include "core/picture/text_file.h"
#include "ui/session/files.h"

#include <QCoreApplication>
#include <QDir>
#include <QSettings>

#include <cstdio>
#include <limits>

namespace tetra {
namespace {

constexpr int entries = 300; ///< enough that writing them takes a while

std::filesystem::path sessionIn(const QString& folder)
{
    return (folder + "/work.tansession").toStdString();
}

Status writeOnce(const QString& folder, int round)
{
    SessionDocument document;
    document.model = (folder + "/model.tan").toStdString();
    document.view.query.budget = static_cast<std::uint64_t>(round);
    document.view.isovalues.resize(entries);
    QSettings settings(folder + "/tan.conf", QSettings::IniFormat);
    for (int entry = 0; entry < entries; ++entry)
        settings.setValue(QString("entry%1").arg(entry), round);
    settings.sync();
    return writeTextFile(sessionIn(folder), sessionToText(document, folder.toStdString()));
}

/// Nothing if all is well.
QString whatIsWrong(const QString& folder)
{
    if (QFile::exists(folder + "/work.tansession")) {
        const auto text = readTextFile(sessionIn(folder));
        if (!text)
            return QString::fromStdString(text.error().text());
        const auto read = sessionFromText(*text, folder.toStdString());
        if (!read)
            return QString::fromStdString(read.error().text());
        if (read->view.isovalues.size() != entries)
            return "A session without its isovalues.";
    }
    if (QFile::exists(folder + "/tan.conf")) {
        QSettings settings(folder + "/tan.conf", QSettings::IniFormat);
        const QVariant round = settings.value("entry0");
        for (int entry = 0; entry < entries; ++entry)
            if (settings.value(QString("entry%1").arg(entry)) != round)
                return "Settings of two rounds in one file.";
    }
    if (const Status again = writeOnce(folder, 0); !again)
        return QString::fromStdString(again.error().text());
    const QStringList left = QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    return left.size() == 2 ? QString() : "Left behind: " + left.join(", ");
}

} // namespace
} // namespace tetra

int main(int argumentCount, char** arguments)
{
    const QCoreApplication application(argumentCount, arguments);
    if (argumentCount != 3)
        return 2;
    const QString folder = QString::fromLocal8Bit(arguments[2]);
    if (qstrcmp(arguments[1], "check") == 0) {
        const QString wrong = tetra::whatIsWrong(folder);
        std::fputs(qPrintable(wrong), stderr);
        return wrong.isEmpty() ? 0 : 1;
    }
    for (int round = 1; round < std::numeric_limits<int>::max(); ++round)
        if (!tetra::writeOnce(folder, round))
            return 1;
    return 0;
}
