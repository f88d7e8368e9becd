// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"
#include "core/refine/lattice/packed_lattice.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A bucket of points: those inside one tetrahedron, and the one with the largest error among them.
struct PointBucket {
    std::uint32_t count = 0;       ///< 0: not in use
    std::uint32_t place = 0;       ///< in the PointPool; of no meaning when the only point is `worst`
    PackedPoint worst = 0;         ///< the point of the largest error; among equals the first in the lattice
    float error = 0;               ///< its error, never rounded down
    std::uint32_t tetrahedron = 0; ///< slot
};

/// Buckets by falling error, ties by the point's place in the lattice (S3): a queue of classes on the leading bits of
/// the error, only the foremost classes kept as a heap. Entries whose bucket has changed since are dropped when they
/// are met, and swept out when they outnumber the others.
class ErrorQueue {
public:
    /// Empties the queue. Errors are expected up to `largestError`, the extent of the values; larger ones are only
    /// slower. Comes first.
    void start(float largestError);

    /// O(1). Buckets without error need not be pushed.
    void push(std::uint32_t bucket, const PointBucket& content)
    {
        const std::uint32_t entryClass = classOf(content.error);
        ++entryCount_;
        if (entryClass >= foremost_) {
            heap_.push_back(candidate(bucket, content));
            std::push_heap(heap_.begin(), heap_.end());
            return;
        }
        classes_[entryClass].push_back({bucket, content.error});
    }

    /// The bucket of the largest error, or none. It stays in the queue until its content changes.
    static constexpr std::uint32_t none = 0xffffffff;
    std::uint32_t top(std::span<const PointBucket> buckets);

    /// A bucket that will probably be the top after `ahead` others, or none; a hint for fetching ahead.
    std::uint32_t probableNext(std::size_t ahead) const
    {
        return sorted_.size() <= ahead ? none : sorted_[sorted_.size() - 1 - ahead].bucket;
    }

    /// Drops what has changed; worth calling when `live` buckets are far fewer than entryCount().
    void sweep(std::span<const PointBucket> buckets);
    std::uint64_t entryCount() const noexcept { return entryCount_; }

    /// After start().
    void archive(StateArchive& archive) { archive(classes_, sorted_, heap_, foremost_, entryCount_); }

private:
    /// Classes take ten bits of the fraction, over 24 octaves below the largest error; what is smaller shares the last.
    static constexpr std::uint32_t classShift = 15;
    static constexpr std::uint32_t classCount = 24u << (23 - classShift);

    std::uint32_t classOf(float error) const
    {
        const std::uint32_t number = std::bit_cast<std::uint32_t>(error) >> classShift;
        return std::clamp(number, firstClass_, firstClass_ + classCount - 1) - firstClass_;
    }

    struct Waiting {
        std::uint32_t bucket;
        float error;
    };
    struct Candidate {
        std::uint64_t key; ///< the bits of the error, then the complement of the point, whose order is the lattice's
        std::uint32_t bucket;
        bool operator<(const Candidate& other) const { return key < other.key; }
    };

    Candidate candidate(std::uint32_t bucket, const PointBucket& content) const
    {
        return {std::uint64_t(std::bit_cast<std::uint32_t>(content.error)) << 32 | ~content.worst, bucket};
    }
    bool openNextClass(std::span<const PointBucket> buckets);
    bool current(const Candidate& candidate, std::span<const PointBucket> buckets) const;

    std::vector<std::vector<Waiting>> classes_;
    std::vector<Candidate> sorted_; ///< the open class when it was opened, the largest last
    std::vector<Candidate> heap_;   ///< what came since and belongs to it or above
    std::uint32_t firstClass_ = 0;
    std::uint32_t foremost_ = 0; ///< classes above are empty
    std::uint64_t entryCount_ = 0;
};

} // namespace tetra
