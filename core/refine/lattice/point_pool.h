// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/free_blocks.h"
#include "core/base/reserved_array.h"
#include "core/base/saved_state.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace tetra {

/// Storage for many short lists of points. That free blocks are never joined again does no harm: the buckets of a
/// refinement only get smaller.
class PointPool {
public:
    /// Places are numbers of 32 bits, and blocks are up to twice as long as their lists.
    static constexpr std::uint64_t mostPoints = (std::uint64_t{1} << 31) - 64;
    /// An error if so many points are too many.
    static Status checkSize(std::uint64_t points)
    {
        if (points <= mostPoints)
            return {};
        return Error{
            ErrorKind::OutOfResource,
            Message::say("More than %1 points cannot be refined at once. Crop or subsample the data.", mostPoints)};
    }

    /// Empties the pool and makes room for lists of `points` points in all, at any time.
    Status reserve(std::uint64_t points)
    {
        if (Status status = checkSize(points); !status)
            return status;
        freeBlocks_.clear();
        used_ = nowhere + minimumBlock;
        return storage_.ensure(2 * points + std::uint64_t{64} * minimumBlock,
                               Message::marked("the points of the refinement"));
    }

    /// The place of a block for `count` points, at least one and at most 2^31.
    std::uint32_t allocate(std::uint32_t count)
    {
        const std::uint32_t wanted = blockClass(count);
        if (const std::uint32_t place = freeBlocks_.take(storage_.data(), wanted); place != FreeBlocks::none)
            return place;
        const std::uint32_t place = used_;
        used_ += 1u << wanted;
        return place;
    }

    /// Gives back the block of `count` points at `place`.
    void free(std::uint32_t place, std::uint32_t count)
    {
        freeBlocks_.putBack(storage_.data(), place, blockClass(count));
    }

    std::span<PackedPoint> points(std::uint32_t place, std::uint32_t count) { return {storage_.data() + place, count}; }
    void put(std::uint32_t place, PackedPoint point) { storage_[place] = point; }
    /// A place that is never allocated, for points that nobody will read.
    static constexpr std::uint32_t nowhere = 0;

    void prefetch(std::uint32_t place) const { __builtin_prefetch(storage_.data() + place); }

    /// Copies a short list quickly: `to` must have room for copyPadding points more.
    void copy(std::uint32_t place, std::uint32_t count, PackedPoint* to) const
    {
        for (std::uint32_t i = 0; i < count; i += copyPadding)
            std::memcpy(to + i, storage_.data() + place + i, copyPadding * sizeof(PackedPoint));
    }
    static constexpr std::uint32_t copyPadding = 4;

    /// After reserve().
    void archive(StateArchive& archive)
    {
        archive(used_, freeBlocks_);
        archive.elements(std::span(storage_.data(), used_));
    }

private:
    static constexpr std::uint32_t minimumBlock = 2;

    static std::uint32_t blockClass(std::uint32_t count) { return FreeBlocks::classOf(std::max(count, minimumBlock)); }

    ReservedArray<PackedPoint> storage_;
    FreeBlocks freeBlocks_;
    std::uint32_t used_ = 0;
};

} // namespace tetra
