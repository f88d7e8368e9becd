// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/kept_views.h"

#include "core/picture/text_file.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <tan/open.h>

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QStandardPaths>

#include <cstring>
#include <utility>

namespace tetra {
namespace {

constexpr qsizetype mostViews = 200;
constexpr qint64 longestKept = 365; // days
constexpr const char* ending = ".tansession";
constexpr const char* lostEnding = ".lost.tansession";
constexpr const char* endedEnding = ".ended.lost.tansession"; ///< one of these
constexpr const char* lockEnding = ".lock";
/// Beside the views: where the first programs kept sessions, in files that went when they ended as they should.
constexpr const char* firstFolder = "recovery";

/// One for all the ways to name the same file.
std::filesystem::path realPath(const std::filesystem::path& path)
{
    if (isAddress(path.string()))
        return path;
    std::error_code unknown;
    auto real = std::filesystem::weakly_canonical(path, unknown);
    return unknown ? path : real;
}

QString fileOf(const QDir& folder, const std::filesystem::path& what)
{
    const QByteArray key = QCryptographicHash::hash(pathText(realPath(what)).toUtf8(), QCryptographicHash::Sha1);
    return folder.filePath(key.toHex() + ending);
}

/// Where the view of that file goes when it is lost.
QString asideOf(const QString& file, const char* lost)
{
    return file.chopped(qsizetype(std::strlen(ending))) + lost;
}

/// Belongs to a program that runs as long as that runs, however long.
std::unique_ptr<QLockFile> takeLock(const QString& file)
{
    auto lock = std::make_unique<QLockFile>(file + lockEnding);
    lock->setStaleLockTime(0);
    return lock->tryLock(0) ? std::move(lock) : nullptr;
}

} // namespace

KeptViews::KeptViews(std::filesystem::path folder, QObject* parent) : QObject(parent), folder_(std::move(folder)) {}

KeptViews::~KeptViews() = default;

void KeptViews::keep(const std::filesystem::path& what, const SessionDocument& document)
{
    write(what, sessionToText(document, folder_));
}

void KeptViews::setAside(const std::filesystem::path& what, const SessionDocument& document)
{
    write(what, sessionToText(document, folder_), Place::Aside);
}

void KeptViews::forget(const std::filesystem::path& what)
{
    write(what, std::nullopt);
}

void KeptViews::release()
{
    writing_.enqueue([this](const Progress&) -> std::function<void()> {
        lock({});
        return [] {};
    });
}

void KeptViews::write(const std::filesystem::path& what, const std::optional<std::string>& text, Place place)
{
    const quint64 number = ++newest_;
    {
        const std::lock_guard guard(mutex_);
        pending_[what] = {number, place == Place::Open ? text : std::nullopt};
    }
    writing_.enqueue([this, what, text, place, number](const Progress&) -> std::function<void()> {
        return [this, what, number, status = writeNow(what, text, place)] { written(what, number, status); };
    });
}

/// What is open is not lost: it goes from where a program looks for that.
Status KeptViews::setAsideNow(const QString& file, const std::string& text)
{
    const Status status = writeTextFile(filePath(asideOf(file, endedEnding)), text);
    if (status) {
        QFile::remove(file);
        lock({});
        aside_ = file;
    }
    return status;
}

Status KeptViews::writeNow(const std::filesystem::path& what, const std::optional<std::string>& text, Place place)
{
    const QDir folder(pathText(folder_));
    const QString file = fileOf(folder, what);
    if (place == Place::Open && file == aside_) // the program has gone on
        QFile::remove(asideOf(std::exchange(aside_, {}), endedEnding));
    if (!text) {
        QFile::remove(file);
        lock({});
        return {};
    }
    if (!folder.mkpath("."))
        return Error{ErrorKind::CannotWrite, Message::say("The folder '%1' cannot be written to, so that the view "
                                                          "cannot be kept. Free some space there, or save the session.",
                                                          folder_.string())};
    if (place == Place::Aside)
        return setAsideNow(file, *text);
    lock(file);
    const bool isNew = !QFile::exists(file);
    Status status = writeTextFile(filePath(file), *text);
    if (isNew)
        removeOld();
    return status;
}

/// Where another program has the lock, that one's is enough.
void KeptViews::lock(const QString& file)
{
    if (file == locked_ && (lock_ || file.isEmpty()))
        return;
    lock_.reset();
    locked_ = file;
    if (!file.isEmpty())
        lock_ = takeLock(file);
}

void KeptViews::written(const std::filesystem::path& what, quint64 number, const Status& status)
{
    {
        const std::lock_guard guard(mutex_);
        if (const auto found = pending_.find(what); found != pending_.end() && found->second.number == number)
            pending_.erase(found);
    }
    if (!status && !told_)
        emit failed(translatedMessage(status.error().message));
    told_ = !status;
}

std::optional<SessionDocument> KeptViews::find(const std::filesystem::path& what) const
{
    const std::filesystem::path real = realPath(what);
    const auto read = [this](const std::string& text) -> std::optional<SessionDocument> {
        auto document = sessionFromText(text, folder_);
        return document ? std::optional(*std::move(document)) : std::nullopt;
    };
    const auto pending = [this] {
        const std::lock_guard guard(mutex_);
        return pending_;
    }();
    for (const auto& [path, newer] : pending)
        if (realPath(path) == real)
            return newer.text ? read(*newer.text) : std::nullopt;
    const auto text = readTextFile(filePath(fileOf(QDir(pathText(folder_)), what)));
    return text ? read(*text) : std::nullopt;
}

std::vector<LostView> KeptViews::lost() const
{
    const QDir folder(pathText(folder_));
    for (const QString& name : folder.entryList({QString("*") + ending + lockEnding}, QDir::Files)) {
        const QString file = folder.filePath(name.chopped(qsizetype(std::strlen(lockEnding))));
        // Who can have the lock has found a file without a program.
        const auto lock = takeLock(file);
        if (!lock || !QFile::exists(file))
            continue;
        const QString aside = asideOf(file, lostEnding);
        QFile::remove(aside);
        QFile::rename(file, aside);
    }
    const QDir first(pathText(folder_.parent_path() / firstFolder));
    for (const QString& name : first.entryList({QString("*") + ending}, QDir::Files)) {
        const QString aside = folder.filePath(name.chopped(qsizetype(std::strlen(ending))) + lostEnding);
        if (const auto lock = takeLock(first.filePath(name)); lock && folder.mkpath("."))
            QFile::rename(first.filePath(name), aside);
    }
    std::vector<LostView> lost;
    for (const QString& name :
         folder.entryList({QString("*") + lostEnding}, QDir::Files | QDir::Readable, QDir::Time)) {
        const std::filesystem::path path = filePath(folder.filePath(name));
        const auto text = readTextFile(path);
        if (!text)
            continue;
        if (const auto document = sessionFromText(*text, folder_))
            lost.push_back({path, *document, name.endsWith(endedEnding)});
    }
    return lost;
}

void KeptViews::removeLost(const std::filesystem::path& path) const
{
    if (path.parent_path() == folder_ && pathText(path).endsWith(lostEnding))
        QFile::remove(pathText(path));
}

/// But not what is open somewhere.
void KeptViews::removeOld() const
{
    const QDir folder(pathText(folder_));
    const QDateTime oldest = QDateTime::currentDateTime().addDays(-longestKept);
    const QFileInfoList files = folder.entryInfoList({QString("*") + ending}, QDir::Files, QDir::Time);
    for (qsizetype i = 0; i < files.size(); ++i)
        if ((i >= mostViews || files[i].lastModified() < oldest) && !QFile::exists(files[i].filePath() + lockEnding))
            QFile::remove(files[i].filePath());
}

std::filesystem::path viewFolder()
{
    return filePath(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/views");
}

} // namespace tetra
