// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>

#include <unistd.h>

namespace tetra {

/// Reads all of `to` from a place in a file, whatever signals come. 0, or the system's error; EIO if the file ends
/// before.
inline int readFully(int descriptor, std::uint64_t offset, std::span<std::byte> to) noexcept
{
    while (!to.empty()) {
        const ssize_t got = ::pread(descriptor, to.data(), to.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return got < 0 ? errno : EIO;
        to = to.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return 0;
}

/// Writes all of `bytes` at a place in a file, likewise. 0, or the system's error; ENOSPC if it takes no more.
inline int writeFully(int descriptor, std::uint64_t offset, std::span<const std::byte> bytes) noexcept
{
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return written < 0 ? errno : ENOSPC;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
    return 0;
}

} // namespace tetra
