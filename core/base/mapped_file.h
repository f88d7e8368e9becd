// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace tetra {

/// A file mapped read-only. Its pages come into memory when they are read and leave it when memory is short, so a file
/// may be larger than the machine. Safe to read from any number of threads.
///
/// A file that another program cuts short, or a disk that fails, while it is mapped must not end this program: reads
/// then give zeros and damaged() becomes true. For that the first open() installs a handler for SIGBUS, the one
/// process-wide thing in core. Signals that do not come from a mapping of this class go on to the handler that was
/// there before; a program with a handler of its own installs it first.
class TAN_INTERNAL MappedFile {
public:
    /// Errors: a file that is missing, no regular file or not readable; too many mapped files (1024).
    static Result<std::shared_ptr<const MappedFile>> open(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }
    std::span<const std::byte> bytes() const noexcept { return bytes_; }

    /// True once the file was found cut short, unreadable or written to since it was opened: what was read may be
    /// wrong. One system call; ask after reading, not while.
    bool damaged() const noexcept;

private:
    MappedFile() = default;

    std::filesystem::path path_;
    std::span<const std::byte> bytes_;
    int descriptor_ = -1;
    std::int64_t modified_ = 0; ///< nanoseconds
    int guard_ = -1;            ///< index in the table that the signal handler reads
};

} // namespace tetra
