// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/scratch_file.h"

#include "core/base/positioned_io.h"
#include "core/base/system_error.h"

#include <cerrno>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace tetra {

namespace {

Error refused(const std::filesystem::path& folder, int systemError)
{
    return {isLackOfResources(systemError) ? ErrorKind::OutOfResource : ErrorKind::CannotWrite,
            Message::say("Cannot make a temporary file in '%1': %2. %3", folder.string(), systemErrorText(systemError),
                         diskRemedy(systemError))};
}

} // namespace

Result<ScratchFile> ScratchFile::create(const std::filesystem::path& folder, std::size_t bytes)
{
    ScratchFile file;
    if (bytes == 0)
        return file;
    std::string name = (folder / "scratch-XXXXXX").string();
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0)
        return refused(folder, errno);
    ::unlink(name.c_str());
    int problem = ::posix_fallocate(descriptor, 0, static_cast<off_t>(bytes));
    void* mapped = MAP_FAILED;
    if (problem == 0) {
        mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
        problem = errno;
    }
    ::close(descriptor);
    if (mapped == MAP_FAILED)
        return refused(folder, problem);
    file.bytes_ = std::shared_ptr<std::byte>(static_cast<std::byte*>(mapped),
                                             [bytes](std::byte* memory) { ::munmap(memory, bytes); });
    file.size_ = bytes;
    return file;
}

SpoolFile::~SpoolFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

Error SpoolFile::failed(int systemError) const
{
    return {isLackOfResources(systemError) ? ErrorKind::OutOfResource : ErrorKind::CannotWrite,
            Message::say("A temporary file in '%1' cannot be used: %2. %3", folder_.string(),
                         systemErrorText(systemError), diskRemedy(systemError))};
}

Status SpoolFile::open()
{
    std::string name = (folder_ / "spool-XXXXXX").string();
    descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0)
        return failed(errno);
    ::unlink(name.c_str());
    return {};
}

Result<std::uint64_t> SpoolFile::append(std::span<const std::byte> bytes)
{
    if (status_ && descriptor_ < 0)
        status_ = open();
    const std::uint64_t offset = size_;
    if (status_)
        if (const int problem = writeFully(descriptor_, offset, bytes); problem != 0)
            status_ = failed(problem);
    if (!status_)
        return status_.error();
    size_ += bytes.size();
    return offset;
}

Status SpoolFile::read(std::uint64_t offset, std::span<std::byte> bytes) const
{
    const int problem = readFully(descriptor_, offset, bytes);
    return problem == 0 ? Status() : failed(problem);
}

} // namespace tetra
