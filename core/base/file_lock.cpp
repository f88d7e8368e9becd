// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_lock.h"

#include "core/base/folder.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

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

FileLock lockFile(int descriptor, const std::filesystem::path& path) noexcept
{
    int result = ::flock(descriptor, LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EINTR)
        result = ::flock(descriptor, LOCK_EX | LOCK_NB);
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
