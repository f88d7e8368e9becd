// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/curvilinear_mesh.h"

#include "core/mesh/circumsphere.h"
#include "core/mesh/lattice_walk.h"
#include "core/mesh/rounding.h"

#include <algorithm>
#include <cmath>

namespace tetra {

CurvilinearMesh::CurvilinearMesh(const LiftedGrid& grid, const BlockDivision& blocks, const Options& options)
    : grid_(grid), blocks_(blocks), options_(options)
{
    queue_.start(roundedUp(std::max(options.largestError, options.warpingWeight * options.largestWarping)));
    warpingQueue_.start(roundedUp(options.largestWarping));
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

/// The largest of `measures`; ties go to the first point of the lattice.
std::size_t CurvilinearMesh::worstOf(std::span<const double> measures, std::span<const PackedPoint> points) const
{
    std::size_t worst = 0;
    for (std::size_t i = 1; i < measures.size(); ++i)
        if (measures[i] > measures[worst] || (measures[i] == measures[worst] && points[i] < points[worst]))
            worst = i;
    return worst;
}

/// Makes the bucket of `slot` out of what the relocation placed into `face` of its star.
CurvilinearMesh::Accuracy CurvilinearMesh::fillBucket(std::uint32_t slot, std::size_t face, double determinant)
{
    const std::uint32_t first = relocation_.offsets()[face];
    const std::uint32_t count = relocation_.offsets()[face + 1] - first;
    if (count == 0)
        return {};
    const std::span<const PackedPoint> points = relocation_.placed().subspan(first, count);
    const std::span<const double> errors = relocation_.scaledSquaredErrors().subspan(first, count);
    const std::span<const double> warpings = relocation_.scaledSquaredWarpings().subspan(first, count);
    const auto measure = [&](std::span<const double> squares, double least) {
        const double largest = std::sqrt(*std::ranges::max_element(squares)) / determinant;
        return largest <= least ? 0 : largest;
    };
    const double error = measure(errors, grid_.leastError());
    const double warping = measure(warpings, grid_.leastWarping());
    const Accuracy accuracy{roundedUp(error), roundedUp(warping),
                            roundedUp(std::max(error, options_.warpingWeight * warping))};

    const std::uint32_t number = takeBucketNumber();
    slots_[slot].bucket = number;
    PointBucket& bucket = buckets_[number];
    bucket = {count, 0, points[0], 0, slot};
    if (count > 1) {
        bucket.place = pool_.allocate(count);
        std::ranges::copy(points, pool_.points(bucket.place, count).begin());
    }
    if (options_.selection == CurvilinearSelection::Paper) {
        PointBucket& warpingBucket = warpingBuckets_[number];
        warpingBucket = bucket;
        warpingBucket.worst = points[worstOf(warpings, points)];
        warpingBucket.error = accuracy.warping;
        if (accuracy.warping > 0)
            warpingQueue_.push(number, warpingBucket);
        bucket.worst = points[worstOf(errors, points)];
        bucket.error = accuracy.error;
    } else {
        const double squaredWeight = options_.warpingWeight * options_.warpingWeight;
        keys_.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            keys_[i] = std::max(errors[i], squaredWeight * warpings[i]);
        bucket.worst = points[worstOf(keys_, points)];
        bucket.error = accuracy.key;
    }
    if (bucket.error > 0)
        queue_.push(number, bucket);
    if (accuracy.key > options_.stopKey)
        pointsAboveStop_ += count;
    return accuracy;
}

/// Finds out whether lifting flips the tetrahedron of `slot`, and queues it if so.
void CurvilinearMesh::noteOrientation(std::uint32_t slot, float key)
{
    SlotState& state = slots_[slot];
    state.orientation = grid_.orientation(delaunay_[slot].vertices);
    degenerate_ += state.orientation == 0;
    if (state.orientation >= 0)
        return;
    ++inverted_;
    if (options_.selection == CurvilinearSelection::Paper)
        return;
    if (state.bucket == none)
        emptyFlips_.push_back({slot, state.history});
    else
        flips_.push(key, buckets_[state.bucket].worst, slot, state.history);
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
            PointBucket& warpingBucket = warpingBuckets_[state.bucket];
            key = std::max(key, roundedUp(options_.warpingWeight * double(warpingBucket.error)));
            warpingBucket.count = 0;
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
        noteOrientation(created, accuracy.key);
        const std::array<std::uint32_t, 3>& corners = star.corners()[face];
        starHistory_.push_back(
            {{rimSites_[corners[0]], rimSites_[corners[1]], rimSites_[corners[2]]}, accuracy.error, accuracy.warping});
    }
    hints_[block] = delaunay_.created()[0];
    return true;
}

Status CurvilinearMesh::insert(const Candidate& candidate, float keyBefore, HistorySink& sink)
{
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
    if (const std::uint32_t slot = flips_.top(alive); slot != FlipQueue::none) {
        const PointBucket& bucket = buckets_[slots_[slot].bucket];
        return {bucket.worst, slot, bucket.error};
    }
    while (!emptyFlips_.empty()) {
        const auto [slot, history] = emptyFlips_.back();
        emptyFlips_.pop_back();
        if (!alive(slot, history))
            continue;
        const auto cure = deepestPointInSphere(grid_.lattice(), delaunay_[slot], blocks_.box(slots_[slot].block));
        if (cure)
            return {*cure, slot, 0};
    }
    return {};
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
