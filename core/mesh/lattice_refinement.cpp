// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lattice_refinement.h"

#include "core/mesh/error_queue.h"
#include "core/mesh/lattice_delaunay.h"
#include "core/mesh/point_pool.h"
#include "core/mesh/relocation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t none = 0xffffffff;

float roundedUp(double value)
{
    const float rounded = static_cast<float>(value);
    return static_cast<double>(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                                                : rounded;
}

/// The state of one refinement: the mesh, the buckets of points inside its tetrahedra, and the queue of their errors.
class Refinement {
public:
    Refinement(const LatticeRefinementOptions& options, const LatticeSamples& samples, HistorySink& sink)
        : options_(options), samples_(samples), sink_(sink), lattice_(options.size),
          queue_(lattice_, roundedUp(options.valueExtent))
    {
    }

    Result<LatticeRefinementResult> run(const Progress& progress);

private:
    /// What is kept for each slot besides its geometry.
    struct SlotState {
        std::uint32_t history; ///< its tetrahedron's number in the history
        std::uint32_t bucket;  ///< none if no point is inside
    };

    Status start();
    Status distributeStart();
    Status addCorners();
    Status insertWorst(PointBucket worst);
    void collectDestroyed();
    float fillBucket(std::uint32_t slot, std::size_t face, double determinant);
    std::uint32_t takeBucketNumber();
    bool counts(float error) const { return error > options_.stopError; }

    const LatticeRefinementOptions& options_;
    const LatticeSamples& samples_;
    HistorySink& sink_;
    PackedLattice lattice_;
    LatticeDelaunay delaunay_;
    PointPool pool_;
    std::vector<PointBucket> buckets_;
    std::vector<std::uint32_t> freeBuckets_;
    ErrorQueue queue_;
    ReservedArray<SlotState> slots_;
    ReservedArray<std::uint32_t> siteOfPoint_;
    Relocation relocation_;
    std::uint64_t pointsAboveStop_ = 0; ///< points in tetrahedra that must still be refined: what is left to do
    std::uint32_t siteCount_ = 0;
    std::uint64_t tetrahedronCount_ = 0;

    std::vector<PackedPoint> points_;
    std::vector<std::uint32_t> destroyedHistory_;
    std::vector<std::uint32_t> destroyedBuckets_;
    std::vector<std::uint32_t> rimSites_;
    std::vector<HistoryTetrahedron> starHistory_;
    std::array<float, LatticeDelaunay::startCount> startErrors_{};
};

std::uint32_t Refinement::takeBucketNumber()
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
float Refinement::fillBucket(std::uint32_t slot, std::size_t face, double determinant)
{
    const std::uint32_t first = relocation_.offsets()[face];
    const std::uint32_t count = relocation_.offsets()[face + 1] - first;
    if (count == 0) {
        slots_[slot].bucket = none;
        return 0;
    }
    const std::span<const PackedPoint> points = relocation_.placed().subspan(first, count);
    const std::span<const double> errors = relocation_.scaledErrors().subspan(first, count);
    std::size_t worst = 0;
    for (std::size_t i = 1; i < count; ++i)
        if (errors[i] > errors[worst] ||
            (errors[i] == errors[worst] && lattice_.index(points[i]) < lattice_.index(points[worst])))
            worst = i;

    const std::uint32_t number = takeBucketNumber();
    PointBucket& bucket = buckets_[number];
    bucket = {count, 0, points[worst], roundedUp(errors[worst] / determinant), slot};
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

Status Refinement::distributeStart()
{
    std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount> inside;
    const auto& size = options_.size;
    const auto onSide = [this](PackedPoint p, const std::array<PackedPoint, 4>& v) {
        const auto offset = [&](PackedPoint q) -> std::array<std::int64_t, 3> {
            return {lattice_.x(q) - lattice_.x(p), lattice_.y(q) - lattice_.y(p), lattice_.z(q) - lattice_.z(p)};
        };
        const auto a = offset(v[1]), b = offset(v[2]), c = offset(v[3]);
        return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]) >=
               0;
    };
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const PackedPoint point = lattice_.pack(x, y, z);
                const bool corner =
                    (x == 0 || x == size[0] - 1) && (y == 0 || y == size[1] - 1) && (z == 0 || z == size[2] - 1);
                if (corner)
                    continue;
                std::uint32_t slot = 0;
                while (slot < LatticeDelaunay::startCount - 1 && !onSide(point, delaunay_[slot].vertices))
                    ++slot;
                inside[slot].push_back(point);
            }
    Star star;
    if (Status status = star.attach(lattice_); !status)
        return status;
    for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
        const auto& vertices = delaunay_[slot].vertices;
        star.clear(vertices[0]);
        star.addFace(vertices[1], vertices[2], vertices[3]);
        star.finish({1, 1, 1});
        relocation_.run(lattice_, samples_, star, inside[slot]);
        startErrors_[slot] = fillBucket(slot, 0, delaunay_[slot].determinant());
        std::vector<PackedPoint>().swap(inside[slot]);
    }
    return {};
}

/// Hands the eight corners and the five tetrahedra to the sink, each tetrahedron with the latest of its corners.
Status Refinement::addCorners()
{
    const auto& size = options_.size;
    std::array<std::uint32_t, 8> points{};
    for (std::uint32_t corner = 0; corner < points.size(); ++corner) {
        points[corner] = lattice_.index(lattice_.pack((corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1),
                                                      (corner >> 2 & 1) * (size[2] - 1)));
        siteOfPoint_[points[corner]] = corner;
    }
    for (const std::uint32_t point : points) {
        starHistory_.clear();
        for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
            std::array<std::uint32_t, 4> sites{};
            for (std::size_t i = 0; i < 4; ++i)
                sites[i] = siteOfPoint_[lattice_.index(delaunay_[slot].vertices[i])];
            const auto latest = static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin());
            if (sites[latest] != siteCount_)
                continue;
            // An even permutation brings the latest to the front.
            constexpr std::uint8_t order[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
            starHistory_.push_back(
                {{sites[order[latest][0]], sites[order[latest][1]], sites[order[latest][2]]}, startErrors_[slot]});
            slots_[slot].history = static_cast<std::uint32_t>(tetrahedronCount_++);
        }
        if (Status status = sink_.add({point, std::numeric_limits<float>::infinity(), starHistory_, {}}); !status)
            return status;
        ++siteCount_;
    }
    return {};
}

Status Refinement::start()
{
    const Result<LatticeMetric> metric = latticeMetric(options_.size, options_.spacing);
    if (!metric)
        return metric.error();
    if (Status status = delaunay_.start(options_.size, *metric); !status)
        return status;
    const std::uint64_t pointCount = std::uint64_t(options_.size[0]) * options_.size[1] * options_.size[2];
    if (Status status = pool_.reserve(pointCount); !status)
        return status;
    if (Status status = slots_.reserve(delaunay_.capacity(), "the state of the refinement's tetrahedra"); !status)
        return status;
    if (Status status = siteOfPoint_.reserve(pointCount, "the numbers of the sites"); !status)
        return status;
    if (Status status = distributeStart(); !status)
        return status;
    return addCorners();
}

/// Takes the points and the history numbers of what the last insertion destroyed, and gives their buckets back.
void Refinement::collectDestroyed()
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

Status Refinement::insertWorst(PointBucket worst)
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
    const std::uint32_t pointIndex = lattice_.index(point);
    siteOfPoint_[pointIndex] = siteCount_;
    rimSites_.resize(star.rim().size());
    for (std::size_t i = 0; i < rimSites_.size(); ++i)
        rimSites_[i] = siteOfPoint_[lattice_.index(star.rim()[i])];

    const bool hasPoints = points_.size() > 1;
    if (hasPoints)
        relocation_.run(lattice_, samples_, star, points_);
    starHistory_.resize(star.faceCount());
    for (std::size_t face = 0; face < star.faceCount(); ++face) {
        const std::uint32_t slot = delaunay_.created()[face];
        slots_[slot] = {static_cast<std::uint32_t>(tetrahedronCount_ + face), none};
        const std::array<std::uint32_t, 3>& corners = star.corners()[face];
        starHistory_[face] = {{rimSites_[corners[0]], rimSites_[corners[1]], rimSites_[corners[2]]},
                              hasPoints ? fillBucket(slot, face, star.faces()[face].determinant()) : 0.0f};
    }
    tetrahedronCount_ += star.faceCount();
    ++siteCount_;
    return sink_.add({pointIndex, keyBefore, starHistory_, destroyedHistory_});
}

Result<LatticeRefinementResult> Refinement::run(const Progress& progress)
{
    progress.report(0, "Distributing the points");
    if (Status status = start(); !status)
        return status.error();
    const std::uint64_t pointsAtStart = std::max<std::uint64_t>(pointsAboveStop_, 1);
    // Early insertions move millions of points, late ones a few: ask by work done, not by insertions.
    constexpr std::uint64_t workBetweenReports = 1u << 20;
    std::uint64_t work = 0;
    for (;;) {
        const std::uint32_t number = queue_.top(buckets_);
        const float error = number == ErrorQueue::none ? 0.0f : buckets_[number].error;
        if (!counts(error)) {
            if (Status status = sink_.finish(error); !status)
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

} // namespace

Result<LatticeRefinementResult> refineLattice(const LatticeRefinementOptions& options, const LatticeSamples& samples,
                                              HistorySink& sink, const Progress& progress)
{
    try {
        return Refinement(options, samples, sink).run(progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory to refine this lattice. Close other programs, use a "
                                               "machine with more memory, or crop or subsample the data."};
    }
}

} // namespace tetra
