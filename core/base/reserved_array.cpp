// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/reserved_array.h"

#include "core/base/system_error.h"

#include <tan/base.h>

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>

namespace tetra {

Result<std::shared_ptr<void>> reserveMemory(std::size_t bytes, MarkedText purpose)
{
    constexpr std::size_t hugePage = std::size_t(2) << 20;
    const std::size_t length = (std::max<std::size_t>(bytes, 1) + hugePage - 1) / hugePage * hugePage;
    void* const start =
        ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (start == MAP_FAILED)
        return Error{ErrorKind::OutOfResource,
                     Message::say("Not enough memory: %1 MiB of address space for %2 were refused (%3). Close other "
                                  "programs, or raise the memory limit.",
                                  length >> 20, purpose, systemErrorText(errno))};
    ::madvise(start, length, MADV_HUGEPAGE);
    return std::shared_ptr<void>(start, [length](void* memory) { ::munmap(memory, length); });
}

} // namespace tetra
