// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/packed_lattice.h"

#include <bit>
#include <cstdint>
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
/// the error, only the foremost class kept as a heap. Entries whose bucket has changed since are dropped when they are
/// met, and swept out when they outnumber the others.
class ErrorQueue {
public:
    explicit ErrorQueue(const PackedLattice& lattice)
        : lattice_(&lattice), classes_(std::size_t(1) << (32 - classShift))
    {
    }

    /// O(1). Buckets without error need not be pushed.
    void push(std::uint32_t bucket, const PointBucket& content)
    {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(content.error);
        const std::uint32_t entryClass = bits >> classShift;
        ++entryCount_;
        if (entryClass >= foremost_) {
            if (entryClass > foremost_)
                moveForemost(entryClass);
            pushHeap({content.error, lattice_->index(content.worst), bucket});
            return;
        }
        classes_[entryClass].push_back({bucket, content.error});
    }

    /// The bucket of the largest error, or none. It stays in the queue until its content changes.
    static constexpr std::uint32_t none = 0xffffffff;
    std::uint32_t top(const std::vector<PointBucket>& buckets);

    /// Drops what has changed; worth calling when `live` buckets are far fewer than entryCount().
    void sweep(const std::vector<PointBucket>& buckets);
    std::uint64_t entryCount() const noexcept { return entryCount_; }

private:
    static constexpr int classShift = 15; // sign, exponent and eight bits of the fraction

    struct Waiting {
        std::uint32_t bucket;
        float error;
    };
    struct Candidate {
        float error;
        std::uint32_t rank;
        std::uint32_t bucket;
        bool operator<(const Candidate& other) const
        {
            return error != other.error ? error < other.error : rank > other.rank;
        }
    };

    void pushHeap(const Candidate& candidate);
    void moveForemost(std::uint32_t entryClass);
    bool current(const Candidate& candidate, const std::vector<PointBucket>& buckets) const;

    const PackedLattice* lattice_;
    std::vector<std::vector<Waiting>> classes_;
    std::vector<Candidate> heap_;
    std::uint32_t foremost_ = 0;
    std::uint64_t entryCount_ = 0;
};

} // namespace tetra
