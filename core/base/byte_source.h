// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace tetra {

/// `size` bytes from `offset` on.
struct ByteRange {
    std::uint64_t offset = 0;
    std::uint64_t size = 0;

    bool operator==(const ByteRange&) const = default;
};

/// A file that lies somewhere: on a disk (fileSource()) or on a server. Copies share it. What its functions may be
/// called from, one thread or several at once, whoever makes it says.
struct ByteSource {
    std::uint64_t size = 0;
    /// Whether reading all of it costs no more than memory and disk give: a file on this machine.
    bool isLocal = false;
    /// Fills `to` with the bytes from `offset` on. Errors: bytes beyond the end, whatever keeps it from reading them,
    /// cancelled.
    std::function<Status(std::uint64_t offset, std::span<std::byte> to, const Progress& progress)> read;
    /// Has these ranges ready for read(), with as few requests as it takes. A file on a disk does nothing.
    std::function<Status(std::span<const ByteRange> ranges, const Progress& progress)> fetch;
};

/// A file on a disk, which stays mapped as long as a copy lives. From any number of threads. Errors: MappedFile's; of
/// reading: bytes beyond the end, a file that was cut short meanwhile.
Result<ByteSource> fileSource(const std::filesystem::path& path);

} // namespace tetra
