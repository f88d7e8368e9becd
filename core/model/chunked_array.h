// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// An array that grows at its end without ever moving what it holds: growing costs no copy and no moment at which
/// twice the memory is needed. Chunks of 64 Ki elements. Growing may throw std::bad_alloc.
template <class T> class ChunkedArray {
public:
    std::size_t size() const noexcept { return size_; }

    T& operator[](std::size_t index) noexcept { return chunks_[index >> shift][index & mask]; }
    const T& operator[](std::size_t index) const noexcept { return chunks_[index >> shift][index & mask]; }

    void push_back(const T& value)
    {
        if ((size_ & mask) == 0)
            chunks_.push_back(std::make_unique_for_overwrite<T[]>(chunkSize));
        chunks_[size_ >> shift][size_ & mask] = value;
        ++size_;
    }

    std::size_t chunkCount() const noexcept { return chunks_.size(); }
    std::span<const T> chunk(std::size_t number) const noexcept
    {
        return {chunks_[number].get(), std::min(chunkSize, size_ - number * chunkSize)};
    }

private:
    static constexpr std::size_t shift = 16;
    static constexpr std::size_t chunkSize = std::size_t(1) << shift;
    static constexpr std::size_t mask = chunkSize - 1;

    std::vector<std::unique_ptr<T[]>> chunks_;
    std::size_t size_ = 0;
};

} // namespace tetra
