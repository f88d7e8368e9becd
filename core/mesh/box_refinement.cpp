// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/box_refinement.h"

#include "core/base/simd.h"

#include <algorithm>

namespace tetra {

Result<LatticeRefinementResult> BoxRefinement::run(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                                   HistorySink& sink, const Progress& progress)
{
    options_ = options;
    samples_ = &samples;
    sink_ = &sink;
    progress.report(0, "Distributing the points");
    if (Status status = start(); !status)
        return status.error();
    return refine(progress);
}

/// The point's number in the whole lattice.
std::uint64_t BoxRefinement::wholeIndex(PackedPoint point) const
{
    const auto& origin = options_.box.origin;
    const std::uint64_t x = origin[0] + static_cast<std::uint32_t>(lattice_.x(point));
    const std::uint64_t y = origin[1] + static_cast<std::uint32_t>(lattice_.y(point));
    const std::uint64_t z = origin[2] + static_cast<std::uint32_t>(lattice_.z(point));
    return (z * options_.latticeSize[1] + y) * options_.latticeSize[0] + x;
}

std::uint32_t BoxRefinement::takeBucketNumber()
{
    if (freeBuckets_.empty())
        return bucketCount_++;
    const std::uint32_t number = freeBuckets_.back();
    freeBuckets_.pop_back();
    return number;
}

/// Makes the buckets of `slots` out of what the relocation placed into the tetrahedra of its star.
TETRA_SIMD_CLONES void BoxRefinement::fillBuckets(std::span<const std::uint32_t> slots)
{
    // Which tetrahedra have points at all is told without a branch, because nobody could predict it.
    std::size_t filledCount = 0;
    filledFaces_.resize(slots.size());
    for (std::uint32_t face = 0; face < slots.size(); ++face) {
        filledFaces_[filledCount] = face;
        filledCount += relocation_.count(face) > 0;
    }
    places_.resize(slots.size());
    for (const std::uint32_t face : std::span(filledFaces_).first(filledCount)) {
        const std::uint32_t count = relocation_.count(face);
        const std::uint32_t number = takeBucketNumber();
        PointBucket& bucket = buckets_[number];
        bucket = {count, count > 1 ? pool_.allocate(count) : PointPool::nowhere, relocation_.worstPoint(face),
                  relocation_.worstError(face), slots[face]};
        places_[face] = bucket.place;
        slots_[slots[face]].bucket = number;
        if (bucket.error > 0)
            queue_.push(number, bucket);
        if (counts(bucket.error))
            pointsAboveStop_ += count;
    }
    const std::span<const std::int32_t> owners = relocation_.owners();
    for (std::size_t i = 0; i < owners.size(); ++i)
        pool_.put(places_[static_cast<std::size_t>(owners[i])]++, relocation_.points()[i]);
}

/// Takes the points of the last insertion's cavity, without `apex`, and the history numbers of what it destroyed, and
/// gives the buckets back.
TETRA_SIMD_CLONES void BoxRefinement::collectDestroyed(PackedPoint apex)
{
    destroyedHistory_.clear();
    destroyedBuckets_.clear();
    std::size_t count = 0;
    for (const std::uint32_t slot : delaunay_.destroyed()) {
        const SlotState state = slots_[slot];
        destroyedHistory_.push_back(state.history);
        if (state.bucket == none)
            continue;
        destroyedBuckets_.push_back(state.bucket);
        count += buckets_[state.bucket].count;
    }
    if (points_.capacity() > 65536 && count < points_.capacity() / 16)
        Buffer<PackedPoint>().swap(points_);
    points_.resize(count + PointPool::copyPadding);
    count = 0;
    for (const std::uint32_t number : destroyedBuckets_) {
        PointBucket& bucket = buckets_[number];
        if (bucket.count == 1) {
            points_[count] = bucket.worst;
        } else {
            pool_.copy(bucket.place, bucket.count, points_.data() + count);
            pool_.free(bucket.place, bucket.count);
        }
        count += bucket.count;
        if (counts(bucket.error))
            pointsAboveStop_ -= bucket.count;
        bucket.count = 0;
        freeBuckets_.push_back(number);
    }
    *std::find(points_.begin(), points_.end(), apex) = points_[count - 1];
    points_.resize(count - 1);
}

/// Fetches what the next insertions will need, as far as the queue can tell: for one far ahead its bucket, then step by
/// step what the bucket leads to.
void BoxRefinement::fetchAhead() const
{
    const auto ahead = [this](std::size_t steps, const auto& fetch) {
        if (const std::uint32_t number = queue_.probableNext(steps); number != ErrorQueue::none)
            fetch(buckets_[number]);
    };
    ahead(5, [](const PointBucket& bucket) { __builtin_prefetch(&bucket); });
    ahead(4, [this](const PointBucket& bucket) {
        delaunay_.prefetch(bucket.tetrahedron);
        __builtin_prefetch(&slots_[bucket.tetrahedron]);
    });
    ahead(3, [this](const PointBucket& bucket) {
        delaunay_.prefetchNeighbours(bucket.tetrahedron);
        for (const std::uint32_t neighbour : delaunay_[bucket.tetrahedron].neighbours)
            __builtin_prefetch(&slots_[neighbour]);
        pool_.prefetch(bucket.place);
    });
    ahead(2, [this](const PointBucket& bucket) {
        delaunay_.prefetchSurroundings(bucket.tetrahedron);
        for (const std::uint32_t neighbour : delaunay_[bucket.tetrahedron].neighbours)
            if (neighbour != LatticeDelaunay::none)
                __builtin_prefetch(buckets_.data() + slots_[neighbour].bucket);
    });
}

Status BoxRefinement::insertWorst(PointBucket worst)
{
    const PackedPoint point = worst.worst;
    const float keyBefore = worst.error;
    if (!delaunay_.insert(point, worst.tetrahedron))
        return Error{ErrorKind::OutOfResource, "The mesh grew beyond what was reserved for it."};
    for (const std::uint32_t slot : delaunay_.destroyed())
        __builtin_prefetch(&slots_[slot]);
    fetchAhead();
    collectDestroyed(point);
    const Star& star = delaunay_.star();
    const std::span<const std::uint32_t> rimSites = star.labels();
    delaunay_.label(point, siteCount_);
    const std::span<const std::uint32_t> created = delaunay_.created();
    starHistory_.resize(created.size());
    for (std::size_t face = 0; face < created.size(); ++face) {
        slots_[created[face]] = {static_cast<std::uint32_t>(tetrahedronCount_ + face), none};
        const std::array<std::uint32_t, 3>& corners = star.corners()[face];
        starHistory_[face] = {{rimSites[corners[0]], rimSites[corners[1]], rimSites[corners[2]]}};
    }
    if (!points_.empty()) {
        relocation_.run(lattice_, *samples_, star, points_);
        fillBuckets(created);
        for (std::size_t face = 0; face < created.size(); ++face)
            starHistory_[face].error = relocation_.worstError(face);
    }
    tetrahedronCount_ += star.faceCount();
    ++siteCount_;
    return sink_->add({wholeIndex(point), keyBefore, starHistory_, destroyedHistory_});
}

Result<LatticeRefinementResult> BoxRefinement::refine(const Progress& progress)
{
    const std::uint64_t pointsAtStart = std::max<std::uint64_t>(pointsAboveStop_, 1);
    // Early insertions move millions of points, late ones a few: ask by work done, not by insertions.
    constexpr std::uint64_t workBetweenReports = 1u << 20;
    std::uint64_t work = 0;
    for (;;) {
        const std::uint32_t number = queue_.top(buckets());
        const float error = number == ErrorQueue::none ? 0.0f : buckets_[number].error;
        if (!counts(error)) {
            if (Status status = sink_->finish(error); !status)
                return status.error();
            return LatticeRefinementResult{siteCount_, tetrahedronCount_, error};
        }
        if (Status status = insertWorst(buckets_[number]); !status)
            return status.error();
        work += 200 + points_.size();
        if (work < workBetweenReports)
            continue;
        work = 0;
        if (progress.cancelled())
            return cancelledError("The refinement");
        progress.report(1 - static_cast<double>(pointsAboveStop_) / static_cast<double>(pointsAtStart), "Refining");
        if (queue_.entryCount() > 2 * (bucketCount_ - freeBuckets_.size()) + 65536)
            queue_.sweep(buckets());
    }
}

} // namespace tetra
