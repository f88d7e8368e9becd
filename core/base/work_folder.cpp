// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_folder.h"

#include "core/base/system_error.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

/// The file that is locked, and that tells such a folder from one of the user's.
constexpr const char* lockName = ".tan-work";

Error cannotUse(const std::filesystem::path& path, const std::string& reason, const std::string& whatToDo)
{
    return {ErrorKind::CannotWrite, "Cannot work in '" + path.string() + "': " + reason + ". " + whatToDo};
}

void removeContent(const std::filesystem::path& folder)
{
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().filename() != lockName)
            std::filesystem::remove_all(entry.path(), ignored);
}

void removeFolder(const std::filesystem::path& folder)
{
    removeContent(folder);
    std::error_code ignored;
    std::filesystem::remove(folder / lockName, ignored);
    std::filesystem::remove(folder, ignored);
}

/// Whether the folder has content and no lock, so that it is none of these. Who works in one removes its content before
/// its lock.
bool holdsSomethingElse(const std::filesystem::path& folder)
{
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().filename() != lockName && !std::filesystem::exists(folder / lockName, ignored) &&
            std::filesystem::exists(std::filesystem::symlink_status(entry.path(), ignored)))
            return true;
    return false;
}

/// Whether an open file is the one of that name. If it is not, who had it locked before has removed it, and a lock on
/// it keeps nobody out.
bool isNamed(int descriptor, const std::filesystem::path& path)
{
    struct stat open = {};
    struct stat named = {};
    return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

} // namespace

Result<WorkFolder> WorkFolder::open(const std::filesystem::path& path, Leftovers leftovers)
{
    const auto cannotBeUsed = [&](int systemError) {
        return cannotUse(path, systemErrorText(systemError), "Choose another folder for the model.");
    };
    const Error inUse =
        cannotUse(path, "another program is building this model", "Wait for it, or give the model another name.");
    const Error foreign =
        cannotUse(path, "it holds something else", "Give the model another name, or move that folder away.");
    // What is found may be another program that is just coming or leaving, unless it is found again and again.
    Error refusal = inUse;
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::error_code problem;
        std::filesystem::create_directory(path, problem);
        if (problem && problem != std::errc::file_exists)
            return cannotBeUsed(problem.value());
        if (holdsSomethingElse(path)) {
            refusal = foreign;
            continue;
        }
        WorkFolder folder;
        folder.lock_ = ::open((path / lockName).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (folder.lock_ < 0) {
            refusal = cannotBeUsed(errno);
            continue;
        }
        // File systems that cannot lock are believed to have one user.
        if (::flock(folder.lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
            return inUse;
        if (!isNamed(folder.lock_, path / lockName)) {
            refusal = inUse;
            continue;
        }
        folder.path_ = path;
        if (leftovers == Leftovers::Remove)
            removeContent(path);
        return folder;
    }
    return refusal;
}

WorkFolder::~WorkFolder()
{
    if (!path_.empty() && !keep_)
        removeFolder(path_);
    if (lock_ >= 0)
        ::close(lock_);
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)), keep_(other.keep_)
{
}

std::uint64_t freeDiskBytes(const std::filesystem::path& path)
{
    std::error_code problem;
    const auto space = std::filesystem::space(path, problem);
    return problem ? 0 : space.available;
}

} // namespace tetra
