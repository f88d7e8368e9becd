// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

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

/// An array that only grows at its end and is read once, from its beginning: in a spool file but for its last chunk of
/// 16 Ki elements. Growing may throw std::bad_alloc; a file that cannot be written shows in the file's status() and in
/// forEachChunk().
template <class T> class SpooledArray {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    /// `file` outlives the array; several arrays share it.
    explicit SpooledArray(SpoolFile& file) : file_(file) {}

    std::uint64_t size() const noexcept { return offsets_.size() * chunkSize + last_.size(); }

    void push_back(const T& element)
    {
        if (last_.size() == chunkSize)
            spool();
        last_.push_back(element);
    }

    void append(std::span<const T> elements)
    {
        while (!elements.empty()) {
            if (last_.size() == chunkSize)
                spool();
            const auto taken = elements.first(std::min(elements.size(), chunkSize - last_.size()));
            last_.insert(last_.end(), taken.begin(), taken.end());
            elements = elements.subspan(taken.size());
        }
    }

    /// Calls visit(std::span<const T>), which gives a Status, for all elements in order; ends with its first error.
    template <class Visit> Status forEachChunk(Visit&& visit) const
    {
        if (!file_.status())
            return file_.status();
        std::vector<T> chunk(offsets_.empty() ? 0 : chunkSize);
        for (const std::uint64_t offset : offsets_) {
            if (const Status read = file_.read(offset, std::as_writable_bytes(std::span(chunk))); !read)
                return read;
            if (const Status visited = visit(std::span<const T>(chunk)); !visited)
                return visited;
        }
        return visit(std::span<const T>(last_));
    }

private:
    static constexpr std::size_t chunkSize = std::size_t(1) << 14;

    void spool()
    {
        if (const Result<std::uint64_t> offset = file_.append(std::as_bytes(std::span(last_))))
            offsets_.push_back(*offset);
        last_.clear();
    }

    SpoolFile& file_;
    std::vector<std::uint64_t> offsets_;
    std::vector<T> last_;
};

} // namespace tetra
