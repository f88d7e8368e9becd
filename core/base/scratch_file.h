// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace tetra {

/// Bytes in a file of no name, mapped for reading and writing: like memory, but the system may put it on the disk when
/// memory is short. Zero at first; gone with the last copy. The room on the disk is taken at once.
class ScratchFile {
public:
    /// In `folder`. Errors: no room on the disk or in the address space.
    static Result<ScratchFile> create(const std::filesystem::path& folder, std::size_t bytes);

    template <class T> std::span<T> as() const noexcept
    {
        return {reinterpret_cast<T*>(bytes_.get()), size_ / sizeof(T)};
    }

private:
    ScratchFile() = default;

    std::shared_ptr<std::byte> bytes_;
    std::size_t size_ = 0;
};

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
