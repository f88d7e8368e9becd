// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/spool_file.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetra {

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
