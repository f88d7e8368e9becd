// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/scratch_file.h"

#include "core/base/system_error.h"

#include <cerrno>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace tetra {

namespace {

Error refused(const std::filesystem::path& folder, int systemError)
{
    return {isLackOfResources(systemError) ? ErrorKind::OutOfResource : ErrorKind::CannotWrite,
            "Cannot make a temporary file in '" + folder.string() + "': " + systemErrorText(systemError) + ". " +
                diskRemedy(systemError)};
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

} // namespace tetra
