// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder.h"

#include <cerrno>
#include <memory>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

bool isItselfOrAbove(std::string_view name)
{
    return name == "." || name == "..";
}

/// Of an open folder, which it closes; below zero: of none.
void removeContentOf(int folder, std::string_view kept) noexcept
{
    DIR* const opened = folder < 0 ? nullptr : ::fdopendir(folder);
    if (opened == nullptr) {
        if (folder >= 0)
            ::close(folder);
        return;
    }
    while (const dirent* const entry = ::readdir(opened)) {
        const char* const name = entry->d_name;
        if (isItselfOrAbove(name) || name == kept || ::unlinkat(folder, name, 0) == 0)
            continue;
        removeContentOf(::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC), {});
        ::unlinkat(folder, name, AT_REMOVEDIR);
    }
    ::closedir(opened);
}

} // namespace

std::vector<std::filesystem::path> pathsIn(const std::filesystem::path& folder, std::error_code& problem)
{
    std::vector<std::filesystem::path> found;
    const auto close = [](DIR* opened) { ::closedir(opened); };
    const std::unique_ptr<DIR, decltype(close)> opened(::opendir(folder.empty() ? "." : folder.c_str()), close);
    while (opened) {
        errno = 0; // after the last one it stays so
        const dirent* const entry = ::readdir(opened.get());
        if (entry == nullptr)
            break;
        if (!isItselfOrAbove(entry->d_name))
            found.push_back(folder / entry->d_name);
    }
    problem.assign(errno, std::generic_category());
    return found;
}

void removeContent(const std::filesystem::path& folder, std::string_view kept) noexcept
{
    removeContentOf(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC), kept);
}

namespace {

void removeIfLeft(const std::filesystem::path& path)
{
    // Network file systems lock only what is open for writing.
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return;
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
        lockFile(descriptor, path) == FileLock::Taken)
        ::unlink(path.c_str());
    ::close(descriptor);
}

} // namespace

FileLock lockFile(int descriptor, const std::filesystem::path& path, LockKind kind) noexcept
{
    const int operation = (kind == LockKind::Exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB;
    int result = ::flock(descriptor, operation);
    while (result != 0 && errno == EINTR)
        result = ::flock(descriptor, operation);
    if (result != 0)
        return errno == EWOULDBLOCK ? FileLock::Busy : FileLock::Impossible;
    struct stat open {};
    struct stat named {};
    const bool isNamed = ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 &&
                         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
    return isNamed ? FileLock::Taken : FileLock::Gone;
}

void removeLeftFiles(const std::filesystem::path& folder, const std::function<bool(std::string_view name)>& isOurs)
{
    std::error_code ignored;
    for (const std::filesystem::path& path : pathsIn(folder, ignored))
        if (isOurs(path.filename().native()))
            removeIfLeft(path);
}

} // namespace tetra
