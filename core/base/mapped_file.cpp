// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/mapped_file.h"

#include "core/base/mapping_guard.h"
#include "core/base/system_error.h"

#include <cerrno>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

Error cannotRead(const std::filesystem::path& path, const std::string& reason)
{
    return {ErrorKind::BadInput, "Cannot read '" + path.string() + "': " + reason};
}

Error cannotRead(const std::filesystem::path& path, int systemError)
{
    const std::string reason = systemErrorText(systemError) + ".";
    if (isLackOfResources(systemError))
        return {ErrorKind::OutOfResource, cannotRead(path, reason + " " + std::string(resourceRemedy)).text};
    switch (systemError) {
    case ENOENT: return cannotRead(path, reason + " Check its name and folder.");
    case EACCES: return cannotRead(path, reason + " Ask its owner for the right to read it.");
    default: return cannotRead(path, reason);
    }
}

std::int64_t nanoseconds(const timespec& time)
{
    return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

} // namespace

Result<std::shared_ptr<const MappedFile>> MappedFile::open(const std::filesystem::path& path)
{
    const std::shared_ptr<MappedFile> file(new MappedFile);
    file->path_ = path;
    // Without O_NONBLOCK a pipe would make open() wait for a writer.
    file->descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file->descriptor_ < 0)
        return cannotRead(path, errno);
    struct stat status {};
    if (::fstat(file->descriptor_, &status) != 0)
        return cannotRead(path, errno);
    if (S_ISDIR(status.st_mode))
        return cannotRead(path, "it is a folder. Name a file in it.");
    if (!S_ISREG(status.st_mode))
        return cannotRead(path, "it is not a regular file. Copy its content into one first.");
    file->modified_ = nanoseconds(status.st_mtim);
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0)
        return std::shared_ptr<const MappedFile>(file);
    void* const start = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file->descriptor_, 0);
    if (start == MAP_FAILED)
        return cannotRead(path, errno);
    file->bytes_ = {static_cast<const std::byte*>(start), size};
    file->guard_ = guardMapping(file->bytes_);
    if (file->guard_ < 0)
        return Error{ErrorKind::OutOfResource,
                     "Cannot open '" + path.string() + "': too many files are open. Close some of them."};
    return std::shared_ptr<const MappedFile>(file);
}

MappedFile::~MappedFile()
{
    if (guard_ >= 0)
        unguardMapping(guard_);
    if (!bytes_.empty())
        ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

bool MappedFile::damaged() const noexcept
{
    if (guard_ >= 0 && isMappingDamaged(guard_))
        return true;
    // The last page of a file that was cut reads as zeros without any signal.
    struct stat status {};
    return ::fstat(descriptor_, &status) != 0 || static_cast<std::size_t>(status.st_size) != bytes_.size() ||
           nanoseconds(status.st_mtim) != modified_;
}

} // namespace tetra
