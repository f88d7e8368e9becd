// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/reserved_array.h"

#include "core/base/memory.h"

#include <tan/base.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

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

void forEachTouchedRun(const void* memory, std::size_t bytes,
                       const std::function<void(std::size_t first, std::size_t end)>& visit)
{
    // Linux tells of each page whether it is in memory or swapped out, by the highest two bits of a number.
    constexpr std::uint64_t touched = std::uint64_t(3) << 62;
    constexpr std::size_t pagesAtOnce = 1 << 16;
    const std::size_t pageBytes = pageSize();
    const std::size_t firstPage = reinterpret_cast<std::uintptr_t>(memory) / pageBytes; // memory begins with a page
    const std::size_t count = (bytes + pageBytes - 1) / pageBytes;
    std::vector<std::uint64_t> pages(std::min(count, pagesAtOnce)); // may throw, so before the file is open
    const int map = ::open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
    for (std::size_t done = 0; done < count; done += pagesAtOnce) {
        const std::size_t some = std::min(pagesAtOnce, count - done);
        const std::size_t wanted = some * sizeof(std::uint64_t);
        const bool isKnown = map >= 0 && ::pread(map, pages.data(), wanted,
                                                 static_cast<off_t>((firstPage + done) * sizeof(std::uint64_t))) ==
                                             static_cast<ssize_t>(wanted);
        const auto isTouched = [&](std::size_t page) { return !isKnown || (pages[page] & touched) != 0; };
        for (std::size_t page = 0; page < some;) {
            std::size_t end = page;
            while (end < some && isTouched(end))
                ++end;
            if (end > page)
                visit((done + page) * pageBytes, std::min(bytes, (done + end) * pageBytes));
            page = end + 1;
        }
    }
    if (map >= 0)
        ::close(map);
}

} // namespace tetra
