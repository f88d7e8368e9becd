// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/box_refinement.h"

#include "core/mesh/point_errors.h"

#include <algorithm>

namespace tetra {

namespace {

constexpr std::uint32_t none = 0xffffffff;

} // namespace

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
    if (freeBuckets_.empty()) {
        buckets_.emplace_back();
        return static_cast<std::uint32_t>(buckets_.size() - 1);
    }
    const std::uint32_t number = freeBuckets_.back();
    freeBuckets_.pop_back();
    return number;
}

/// Makes the bucket of `slot` out of what the relocation placed into `face` of its star, and gives its error.
float BoxRefinement::fillBucket(std::uint32_t slot, std::size_t face)
{
    const std::uint32_t first = relocation_.offsets()[face];
    const std::uint32_t count = relocation_.offsets()[face + 1] - first;
    if (count == 0) {
        slots_[slot].bucket = none;
        return 0;
    }
    const std::span<const PackedPoint> points = relocation_.placed().subspan(first, count);
    const PlacedError worst =
        worstError(points, relocation_.scaledErrors().subspan(first, count), relocation_.divisors()[face]);

    const std::uint32_t number = takeBucketNumber();
    PointBucket& bucket = buckets_[number];
    bucket = {count, 0, worst.point, worst.error, slot};
    if (count > 1) {
        bucket.place = pool_.allocate(count);
        std::ranges::copy(points, pool_.points(bucket.place, count).begin());
    }
    slots_[slot].bucket = number;
    if (bucket.error > 0)
        queue_.push(number, bucket);
    if (counts(bucket.error))
        pointsAboveStop_ += count;
    return bucket.error;
}

/// Takes the points and the history numbers of what the last insertion destroyed, and gives their buckets back.
void BoxRefinement::collectDestroyed()
{
    if (points_.capacity() > 65536 && points_.size() < points_.capacity() / 16)
        std::vector<PackedPoint>().swap(points_);
    points_.clear();
    destroyedHistory_.clear();
    destroyedBuckets_.clear();
    for (const std::uint32_t slot : delaunay_.destroyed()) {
        const SlotState state = slots_[slot];
        destroyedHistory_.push_back(state.history);
        if (state.bucket != none)
            destroyedBuckets_.push_back(state.bucket);
    }
    for (const std::uint32_t number : destroyedBuckets_) {
        PointBucket& bucket = buckets_[number];
        if (bucket.count == 1) {
            points_.push_back(bucket.worst);
        } else {
            const std::span<const PackedPoint> points = pool_.points(bucket.place, bucket.count);
            points_.insert(points_.end(), points.begin(), points.end());
            pool_.free(bucket.place, bucket.count);
        }
        if (counts(bucket.error))
            pointsAboveStop_ -= bucket.count;
        bucket.count = 0;
        freeBuckets_.push_back(number);
    }
}

Status BoxRefinement::insertWorst(PointBucket worst)
{
    const PackedPoint point = worst.worst;
    const float keyBefore = worst.error;
    const std::uint32_t nextBucket = queue_.probableNext();
    const std::uint32_t nextSlot = nextBucket == ErrorQueue::none ? 0 : buckets_[nextBucket].tetrahedron;
    delaunay_.prefetch(nextSlot);
    if (!delaunay_.insert(point, worst.tetrahedron))
        return Error{ErrorKind::OutOfResource, "The mesh grew beyond what was reserved for it."};
    for (const std::uint32_t slot : delaunay_.destroyed())
        __builtin_prefetch(&slots_[slot]);
    delaunay_.prefetchNeighbours(nextSlot);
    collectDestroyed();
    const Star& star = delaunay_.star();
    siteOfPoint_[lattice_.index(point)] = siteCount_;
    rimSites_.resize(star.rim().size());
    for (std::size_t i = 0; i < rimSites_.size(); ++i)
        rimSites_[i] = siteOfPoint_[lattice_.index(star.rim()[i])];

    const bool hasPoints = points_.size() > 1;
    if (hasPoints)
        relocation_.run(lattice_, *samples_, star, points_);
    starHistory_.resize(star.faceCount());
    for (std::size_t face = 0; face < star.faceCount(); ++face) {
        const std::uint32_t slot = delaunay_.created()[face];
        slots_[slot] = {static_cast<std::uint32_t>(tetrahedronCount_ + face), none};
        const std::array<std::uint32_t, 3>& corners = star.corners()[face];
        starHistory_[face] = {{rimSites_[corners[0]], rimSites_[corners[1]], rimSites_[corners[2]]},
                              hasPoints ? fillBucket(slot, face) : 0.0f};
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
        const std::uint32_t number = queue_.top(buckets_);
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
        if (queue_.entryCount() > 2 * (buckets_.size() - freeBuckets_.size()) + 65536)
            queue_.sweep(buckets_);
    }
}

} // namespace tetra
