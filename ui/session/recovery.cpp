// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/recovery.h"

#include "ui/session/session_document.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>

namespace tetra {
namespace {

QString lockOf(const QString& file)
{
    return file + ".lock";
}

/// Belongs to a program that runs as long as that runs, however long.
std::unique_ptr<QLockFile> makeLock(const QString& file)
{
    auto lock = std::make_unique<QLockFile>(lockOf(file));
    lock->setStaleLockTime(0);
    return lock;
}

} // namespace

Recovery::Recovery(std::filesystem::path folder) : folder_(std::move(folder)) {}

Recovery::~Recovery()
{
    forget();
}

bool Recovery::lock()
{
    if (lock_)
        return true;
    const QDir folder(pathText(folder_));
    if (!folder.mkpath("."))
        return false;
    file_ = folder.filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + "." + sessionSuffix);
    lock_ = makeLock(file_);
    if (lock_->tryLock(0))
        return true;
    lock_.reset();
    return false;
}

Status Recovery::keep(std::string_view text)
{
    if (!lock())
        return Error{ErrorKind::CannotWrite, "The folder '" + folder_.string() +
                                                 "' cannot be written to, so that the session would be lost if the "
                                                 "program ended unexpectedly. Make room there, or save the session."};
    return writeTextFile(filePath(file_), text);
}

void Recovery::forget()
{
    if (!lock_)
        return;
    QFile::remove(file_);
    lock_.reset();
}

std::vector<LostSession> lostSessions(const std::filesystem::path& folder)
{
    std::vector<LostSession> lost;
    const QDir directory(pathText(folder));
    const QStringList names =
        directory.entryList({QString("*.") + sessionSuffix}, QDir::Files | QDir::Readable, QDir::Time);
    for (const QString& name : names) {
        const QString path = directory.filePath(name);
        // Who can have the lock has found a file without a program.
        if (!makeLock(path)->tryLock(0))
            continue;
        if (auto text = readTextFile(filePath(path)); text && sessionFromText(*text, folder))
            lost.push_back({filePath(path), *std::move(text)});
    }
    return lost;
}

void removeLostSession(const LostSession& session)
{
    QFile::remove(pathText(session.path));
}

std::filesystem::path recoveryFolder()
{
    return filePath(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
}

} // namespace tetra
