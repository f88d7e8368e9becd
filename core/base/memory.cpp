// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tetra {

namespace {

/// A line of /proc/self/status such as "VmHWM:   123 kB". (getrusage would count what the parent occupied before exec.)
std::uint64_t statusEntry(std::string_view name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (!line.starts_with(name))
            continue;
        const std::size_t first = line.find_first_of("0123456789");
        std::uint64_t kibibytes = 0;
        if (first != std::string::npos)
            std::from_chars(line.data() + first, line.data() + line.size(), kibibytes);
        return kibibytes * 1024;
    }
    return 0;
}

} // namespace

std::size_t pageSize() noexcept
{
    return static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::uint64_t physicalBytes() noexcept
{
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    return pages > 0 ? static_cast<std::uint64_t>(pages) * pageSize() : 0;
}

std::uint64_t usableBytes() noexcept
{
    struct rlimit limit {};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return physicalBytes();
    return std::min<std::uint64_t>(physicalBytes(), limit.rlim_cur);
}

std::uint64_t residentBytes()
{
    return statusEntry("VmRSS:");
}

std::uint64_t peakResidentBytes()
{
    return statusEntry("VmHWM:");
}

bool forgetPeakResidentBytes()
{
    ::malloc_trim(0);
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush; // proc(5)
    return file.good();
}

} // namespace tetra
