// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_folder.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
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

} // namespace

Result<WorkFolder> WorkFolder::open(const std::filesystem::path& path, Leftovers leftovers)
{
    std::error_code problem;
    const bool isNew = std::filesystem::create_directory(path, problem);
    if (problem)
        return cannotUse(path, problem.message(), "Choose another folder for the model.");
    std::error_code ignored;
    if (!isNew && !std::filesystem::exists(path / lockName, ignored) && !std::filesystem::is_empty(path, ignored))
        return cannotUse(path, "it holds something else", "Give the model another name, or move that folder away.");
    WorkFolder folder;
    folder.lock_ = ::open((path / lockName).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (folder.lock_ < 0)
        return cannotUse(path, std::generic_category().message(errno), "Choose another folder for the model.");
    // File systems that cannot lock are believed to have one user.
    if (::flock(folder.lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(std::exchange(folder.lock_, -1));
        return cannotUse(path, "another program is building this model",
                         "Wait for it, or give the model another name.");
    }
    folder.path_ = path;
    if (leftovers == Leftovers::Remove)
        removeContent(path);
    return folder;
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
