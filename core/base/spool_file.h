// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace tetra {

/// A file of no name for what is written now and read much later, so that it needs no memory meanwhile. Gone with the
/// object. One thread at a time. Errors: no room on the disk, a disk that cannot be read; after the first one every
/// further append() gives it again.
class SpoolFile {
public:
    /// The file is made in `folder` with the first append().
    explicit SpoolFile(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~SpoolFile();
    SpoolFile(const SpoolFile&) = delete;
    SpoolFile& operator=(const SpoolFile&) = delete;

    /// Where the bytes are in the file.
    Result<std::uint64_t> append(std::span<const std::byte> bytes);
    Status read(std::uint64_t offset, std::span<std::byte> bytes) const;
    /// Whether everything that was appended is there.
    const Status& status() const noexcept { return status_; }

private:
    Status open();
    Error failed(int systemError) const;

    std::filesystem::path folder_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    Status status_;
};

} // namespace tetra
