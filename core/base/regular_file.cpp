// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/regular_file.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

Error cannotReadFile(const std::filesystem::path& path, const Message& reason)
{
    return {ErrorKind::BadInput, Message::say("Cannot read '%1': %2", path.string(), reason)};
}

Error cannotReadFile(const std::filesystem::path& path, int systemError)
{
    const Message reason = systemErrorText(systemError);
    if (isLackOfResources(systemError))
        return {ErrorKind::OutOfResource, cannotReadFile(path, Message::say("%1. %2", reason, resourceRemedy)).message};
    switch (systemError) {
    case ENOENT: return cannotReadFile(path, Message::say("%1. Check its name and folder.", reason));
    case EACCES: return cannotReadFile(path, Message::say("%1. Ask its owner for the right to read it.", reason));
    // A socket, and a device without a driver.
    case ENXIO:
    case ENODEV:
        return cannotReadFile(path, Message::say("it is not a regular file. Copy its content into one first."));
    default: return cannotReadFile(path, Message::say("%1.", reason));
    }
}

Result<RegularFile> RegularFile::open(const std::filesystem::path& path)
{
    // Without O_NONBLOCK a pipe would make open() wait for a writer; regular files do not know it.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor < 0)
        return cannotReadFile(path, errno);
    RegularFile file(path, descriptor);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        return cannotReadFile(path, errno);
    if (S_ISDIR(status.st_mode))
        return cannotReadFile(path, Message::say("it is a folder. Name a file in it."));
    if (!S_ISREG(status.st_mode))
        return cannotReadFile(path, Message::say("it is not a regular file. Copy its content into one first."));
    file.size_ = static_cast<std::uint64_t>(status.st_size);
    file.modified_ = std::int64_t(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec;
    return file;
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(other.release()), size_(other.size_), modified_(other.modified_)
{
}

RegularFile::~RegularFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

int RegularFile::release() noexcept
{
    return std::exchange(descriptor_, -1);
}

Result<std::string> RegularFile::front(std::size_t most) const
{
    constexpr std::size_t step = 1 << 16; // a file may claim any size
    std::string text;
    while (text.size() < most) {
        const std::size_t had = text.size();
        text.resize(std::min(most, had + step));
        const ssize_t got = ::pread(descriptor_, text.data() + had, text.size() - had, static_cast<off_t>(had));
        const int problem = errno;
        text.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got == 0)
            break;
        if (got < 0 && problem != EINTR)
            return cannotReadFile(path_, problem);
    }
    return text;
}

} // namespace tetra
