// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/curvilinear_mesh.h"

#include "core/mesh/circumsphere.h"
#include "core/mesh/lattice_walk.h"
#include "core/mesh/rounding.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tetra {

namespace {

/// The largest of several measures and its point; ties go to the first point of the lattice.
struct Worst {
    double measure = -1;
    PackedPoint point = 0;

    void take(double other, PackedPoint at)
    {
        const bool larger = (other > measure) | ((other == measure) & (at < point));
        measure = larger ? other : measure;
        point = larger ? at : point;
    }
};

} // namespace

CurvilinearMesh::CurvilinearMesh(const LiftedGrid& grid, const BlockDivision& blocks, const Options& options)
    : grid_(grid), blocks_(blocks), options_(options)
{
    queue_.start(roundedUp(std::max(options.largestError, options.warpingWeight * options.largestWarping)));
    warpingQueue_.start(roundedUp(options.largestWarping));
}

float CurvilinearMesh::keyOf(float error, float warping) const
{
    return std::max(error, roundedUp(options_.warpingWeight * double(warping)));
}

std::uint32_t CurvilinearMesh::takeBucketNumber()
{
    if (freeBuckets_.empty()) {
        buckets_.emplace_back();
        if (options_.selection == CurvilinearSelection::Paper)
            warpingBuckets_.emplace_back();
        return static_cast<std::uint32_t>(buckets_.size() - 1);
    }
    const std::uint32_t number = freeBuckets_.back();
    freeBuckets_.pop_back();
    return number;
}

/// Makes the bucket of `slot` out of what the relocation placed into `face` of its star.
CurvilinearMesh::Accuracy CurvilinearMesh::fillBucket(std::uint32_t slot, std::size_t face, double determinant)
{
    const std::uint32_t first = relocation_.offsets()[face];
    const std::uint32_t count = relocation_.offsets()[face + 1] - first;
    if (count == 0)
        return {};
    const std::span<const PackedPoint> points = relocation_.placed().subspan(first, count);
    const double* const errors = relocation_.scaledSquaredErrors().data() + first;
    const double* const warpings = relocation_.scaledSquaredWarpings().data() + first;
    const double squaredWeight = options_.warpingWeight * options_.warpingWeight;
    Worst error, warping, key;
    for (std::size_t i = 0; i < count; ++i) {
        error.take(errors[i], points[i]);
        warping.take(warpings[i], points[i]);
        key.take(std::max(errors[i], squaredWeight * warpings[i]), points[i]);
    }
    const auto bound = [determinant](double scaledSquare, double least) {
        const double value = std::sqrt(scaledSquare) / determinant;
        return value <= least ? 0.0f : roundedUp(value);
    };
    Accuracy accuracy{bound(error.measure, grid_.leastError()), bound(warping.measure, grid_.leastWarping()), 0};
    accuracy.key = keyOf(accuracy.error, accuracy.warping);

    const std::uint32_t number = takeBucketNumber();
    slots_[slot].bucket = number;
    PointBucket& bucket = buckets_[number];
    bucket = {count, 0, key.point, accuracy.key, slot};
    if (count > 1) {
        bucket.place = pool_.allocate(count);
        std::ranges::copy(points, pool_.points(bucket.place, count).begin());
    }
    if (accuracy.key > options_.stopKey)
        pointsAboveStop_ += count;
    if (options_.selection == CurvilinearSelection::Paper) {
        warpingBuckets_[number] = {count, bucket.place, warping.point, accuracy.warping, slot};
        if (accuracy.warping > 0)
            warpingQueue_.push(number, warpingBuckets_[number]);
        bucket.worst = error.point;
        bucket.error = accuracy.error;
    }
    if (bucket.error > 0)
        queue_.push(number, bucket);
    return accuracy;
}

/// Finds out whether lifting flips the tetrahedron of `slot`, and queues it if it may not stay so.
void CurvilinearMesh::noteOrientation(std::uint32_t slot)
{
    SlotState& state = slots_[slot];
    const DelaunayTetrahedron& tetrahedron = delaunay_[slot];
    state.orientation = grid_.orientation(tetrahedron.vertices);
    degenerate_ += state.orientation == 0;
    if (state.orientation >= 0)
        return;
    ++inverted_;
    if (!grid_.bears(tetrahedron.vertices))
        flips_.push(fatness(tetrahedron), tetrahedron.vertices[0], slot, state.history);
}

/// Takes the points and the history numbers of what the last insertion destroyed, and gives their buckets back.
void CurvilinearMesh::collectDestroyed()
{
    if (points_.capacity() > 65536 && points_.size() < points_.capacity() / 16)
        std::vector<PackedPoint>().swap(points_);
    points_.clear();
    for (const std::uint32_t slot : delaunay_.destroyed()) {
        const SlotState state = slots_[slot];
        destroyedHistory_.push_back(state.history);
        inverted_ -= state.orientation < 0;
        degenerate_ -= state.orientation == 0;
        if (state.bucket == none)
            continue;
        PointBucket& bucket = buckets_[state.bucket];
        if (bucket.count == 1) {
            points_.push_back(bucket.worst);
        } else {
            const std::span<const PackedPoint> points = pool_.points(bucket.place, bucket.count);
            points_.insert(points_.end(), points.begin(), points.end());
            pool_.free(bucket.place, bucket.count);
        }
        float key = bucket.error;
        if (options_.selection == CurvilinearSelection::Paper) {
            key = keyOf(bucket.error, warpingBuckets_[state.bucket].error);
            warpingBuckets_[state.bucket].count = 0;
        }
        if (key > options_.stopKey)
            pointsAboveStop_ -= bucket.count;
        bucket.count = 0;
        freeBuckets_.push_back(state.bucket);
    }
}

bool CurvilinearMesh::insertIntoBlock(PackedPoint point, std::uint32_t slot, std::uint32_t block)
{
    if (!delaunay_.insert(point, slot))
        return false;
    for (const std::uint32_t destroyed : delaunay_.destroyed())
        __builtin_prefetch(&slots_[destroyed]);
    delaunay_.prefetchNeighbours(nextSlot_);
    collectDestroyed();
    pointsMoved_ += points_.size();
    const Star& star = delaunay_.star();
    rimSites_.resize(star.rim().size());
    for (std::size_t i = 0; i < rimSites_.size(); ++i)
        rimSites_[i] = siteOfPoint_[index(star.rim()[i])] - 1;
    const bool hasPoints = points_.size() > 1;
    if (hasPoints)
        relocation_.run(grid_, star, points_);
    for (std::size_t face = 0; face < star.faceCount(); ++face) {
        const std::uint32_t created = delaunay_.created()[face];
        slots_[created] = {static_cast<std::uint32_t>(tetrahedronCount_++), none, block, 1};
        const Accuracy accuracy = hasPoints ? fillBucket(created, face, star.faces()[face].determinant()) : Accuracy{};
        noteOrientation(created);
        const std::array<std::uint32_t, 3>& corners = star.corners()[face];
        starHistory_.push_back(
            {{rimSites_[corners[0]], rimSites_[corners[1]], rimSites_[corners[2]]}, accuracy.error, accuracy.warping});
    }
    hints_[block] = delaunay_.created()[0];
    return true;
}

/// Fetches what the next insertion will probably need.
void CurvilinearMesh::prefetchNext()
{
    const std::uint32_t bucket = queue_.probableNext(1);
    nextSlot_ = bucket == ErrorQueue::none ? 0 : buckets_[bucket].tetrahedron;
    delaunay_.prefetch(nextSlot_);
}

Status CurvilinearMesh::insert(const Candidate& candidate, float keyBefore, HistorySink& sink)
{
    prefetchNext();
    const PackedLattice& lattice = grid_.lattice();
    const PackedPoint point = candidate.point;
    const std::uint32_t home = slots_[candidate.slot].block;
    starHistory_.clear();
    destroyedHistory_.clear();
    pointsMoved_ = 0;
    siteOfPoint_[index(point)] = ++siteCount_;
    blocks_.blocksOf({static_cast<std::uint32_t>(lattice.x(point)), static_cast<std::uint32_t>(lattice.y(point)),
                      static_cast<std::uint32_t>(lattice.z(point))},
                     pointBlocks_);
    for (const std::uint32_t block : pointBlocks_) {
        const std::uint32_t slot = block == home ? candidate.slot : walkTo(delaunay_, point, hints_[block]);
        if (!insertIntoBlock(point, slot, block))
            return Error{ErrorKind::OutOfResource, "The mesh grew beyond what was reserved for it."};
    }
    return sink.add({index(point), keyBefore, starHistory_, destroyedHistory_});
}

CurvilinearMesh::Candidate CurvilinearMesh::worst()
{
    const std::uint32_t number = queue_.top(buckets_);
    if (number == ErrorQueue::none)
        return {};
    return {buckets_[number].worst, buckets_[number].tetrahedron, buckets_[number].error};
}

CurvilinearMesh::Candidate CurvilinearMesh::worstWarping()
{
    const std::uint32_t number = warpingQueue_.top(warpingBuckets_);
    if (number == ErrorQueue::none)
        return {};
    return {warpingBuckets_[number].worst, warpingBuckets_[number].tetrahedron, warpingBuckets_[number].error};
}

CurvilinearMesh::Candidate CurvilinearMesh::flipped()
{
    const auto alive = [this](std::uint32_t slot, std::uint32_t history) {
        return delaunay_[slot].determinant() != 0 && slots_[slot].history == history;
    };
    const std::uint32_t slot = flips_.top(alive);
    if (slot == FlipQueue::none)
        return {};
    const auto cure = deepestPointInSphere(grid_.lattice(), delaunay_[slot], blocks_.box(slots_[slot].block));
    assert(cure); // it is not of one cell
    return {*cure, slot, 0};
}

void CurvilinearMesh::sweep()
{
    const std::uint64_t live = buckets_.size() - freeBuckets_.size();
    constexpr std::uint64_t few = 65536;
    if (queue_.entryCount() > 2 * live + few)
        queue_.sweep(buckets_);
    if (warpingQueue_.entryCount() > 2 * live + few)
        warpingQueue_.sweep(warpingBuckets_);
}

} // namespace tetra
