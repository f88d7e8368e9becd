// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_folder.h"

#include "core/base/folder.h"
#include "core/base/system_error.h"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

/// The file that is locked, and that tells such a folder from one of the user's.
constexpr const char* lockName = ".tan-work";

Error cannotUse(const std::filesystem::path& path, const Message& reason, const Message& whatToDo)
{
    return {ErrorKind::CannotWrite, Message::say("Cannot work in '%1': %2. %3", path.string(), reason, whatToDo)};
}

/// All but the lock.
std::vector<std::filesystem::path> workContentOf(const std::filesystem::path& folder, std::error_code& problem)
{
    std::vector<std::filesystem::path> content = pathsIn(folder, problem);
    std::erase_if(content, [](const std::filesystem::path& path) { return path.filename() == lockName; });
    return content;
}

/// Whether the folder has content and no lock, so that it is none of these. Who works in one removes its content before
/// its lock.
bool holdsSomethingElse(const std::filesystem::path& folder, std::error_code& problem)
{
    std::error_code ignored;
    return std::ranges::any_of(workContentOf(folder, problem), [&](const std::filesystem::path& path) {
        return !std::filesystem::exists(folder / lockName, ignored) &&
               std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
    });
}

Error cannotBeUsedForWork(const std::filesystem::path& path, int systemError)
{
    const auto remedy = [&]() -> Message {
        switch (systemError) {
        case ENAMETOOLONG: return Message::say("Choose a shorter name.");
        case ENOSPC:
        case EDQUOT: return diskRemedy(systemError);
        default:
            return isLackOfResources(systemError) ? resourceRemedy
                                                  : Message::say("Choose another folder for the model.");
        }
    };
    Error error = cannotUse(path, systemErrorText(systemError), remedy());
    if (isLackOfResources(systemError))
        error.kind = ErrorKind::OutOfResource;
    return error;
}

} // namespace

Result<WorkFolder> WorkFolder::open(const std::filesystem::path& path, Leftovers leftovers)
{
    const Error inUse = cannotUse(path, Message::say("another program is building this model"),
                                  Message::say("Wait for it, or give the model another name."));
    const Error foreign = cannotUse(path, Message::say("it is used for something else"),
                                    Message::say("Give the model another name, or move that folder away."));
    // One that was made here does not stay empty, whatever comes, lack of memory included.
    const auto removeIfEmpty = [](const std::filesystem::path* empty) { ::rmdir(empty->c_str()); };
    std::unique_ptr<const std::filesystem::path, decltype(removeIfEmpty)> made(nullptr, removeIfEmpty);
    std::filesystem::path own = path;
    std::filesystem::path lockPath = path / lockName;
    // What is found may be another program that is just coming or leaving, unless it is found again and again.
    Error refusal = inUse;
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::error_code problem;
        if (std::filesystem::create_directory(path, problem))
            made.reset(&path);
        if (problem && problem != std::errc::file_exists)
            return cannotBeUsedForWork(path, problem.value());
        if (std::filesystem::is_symlink(path, problem))
            return cannotUse(path, Message::say("it is a link"),
                             Message::say("Give the model another name, or move that link away."));
        const bool isForeign = holdsSomethingElse(path, problem);
        if (isForeign || problem) { // what cannot be looked at may be anything
            refusal = isForeign ? foreign : cannotBeUsedForWork(path, problem.value());
            continue;
        }
        WorkFolder folder;
        folder.lock_ = ::open(lockPath.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (folder.lock_ < 0) {
            refusal = cannotBeUsedForWork(path, errno);
            continue;
        }
        // File systems that cannot lock are believed to have one user.
        const FileLock lock = lockFile(folder.lock_, lockPath);
        if (lock == FileLock::Busy)
            return inUse;
        if (lock == FileLock::Gone) {
            refusal = inUse;
            continue;
        }
        folder.path_ = std::move(own);
        folder.lockPath_ = std::move(lockPath);
        if (leftovers == Leftovers::Remove)
            removeContent(path, lockName);
        return folder;
    }
    return refusal;
}

void WorkFolder::removeLeft(const std::filesystem::path& parent, std::string_view start)
{
    std::error_code problem;
    for (const std::filesystem::path& path : workContentOf(parent, problem)) {
        struct stat status {};
        std::error_code ignored;
        if (path.filename().native().starts_with(start) && ::lstat(path.c_str(), &status) == 0 &&
            S_ISDIR(status.st_mode) && status.st_uid == ::geteuid() &&
            std::filesystem::exists(path / lockName, ignored))
            (void)open(path, Leftovers::Remove); // and goes with this
    }
}

WorkFolder::~WorkFolder()
{
    if (!path_.empty() && !keep_) {
        removeContent(path_, lockName);
        ::unlink(lockPath_.c_str());
        ::rmdir(path_.c_str());
    }
    if (lock_ >= 0)
        ::close(lock_);
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lockPath_(std::move(other.lockPath_)),
      lock_(std::exchange(other.lock_, -1)), keep_(other.keep_)
{
}

std::uint64_t freeDiskBytes(const std::filesystem::path& path)
{
    std::error_code problem;
    const auto space = std::filesystem::space(path, problem);
    return problem ? 0 : space.available;
}

} // namespace tetra
