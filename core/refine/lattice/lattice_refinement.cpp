// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/lattice_refinement.h"

#include "core/base/rounding.h"
#include "core/base/simd.h"
#include "core/mesh/topology.h"
#include "core/refine/lattice/error_queue.h"
#include "core/refine/lattice/point_pool.h"
#include "core/refine/lattice/redistribution.h"

#include <algorithm>
#include <limits>
#include <new>
#include <span>
#include <vector>

namespace tetra {

namespace {

Status checkBox(const LatticeBoxOptions& options)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (options.box.size[axis] < 2 || options.box.size[axis] > options.latticeSize[axis] ||
            options.box.origin[axis] > options.latticeSize[axis] - options.box.size[axis])
            return Error{ErrorKind::WrongUsage, "A block of the lattice needs two points along each axis and must not "
                                                "stick out. Choose another block size."};
    if (!exactWithMetric(options.box.size, options.metric))
        return Error{ErrorKind::OutOfResource, "A block of the lattice is too large to be refined with exact "
                                               "arithmetic. Choose a smaller block size."};
    return {};
}

} // namespace

/// The refinement of one box after another in the same memory: the mesh, the buckets of points inside its tetrahedra,
/// and the queue of their errors. One thread. Allocations throw std::bad_alloc.
class LatticeRefiner::State {
public:
    /// `samples` are those of the box alone. After an error the next run starts afresh.
    Result<LatticeRefinementResult> run(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                        HistorySink& sink, const Progress& progress);

    Buffer<std::byte> boxSamples; ///< room for those of a box

private:
    static constexpr std::uint32_t none = 0xffffffff;
    /// What is kept for each slot besides its geometry.
    struct SlotState {
        std::uint32_t history; ///< its tetrahedron's number in the history
        std::uint32_t bucket;  ///< none if no point is inside
    };

    Status start();
    Status distributeStart();
    Status addCorners();
    Result<LatticeRefinementResult> refine(const Progress& progress);
    Status insertWorst(PointBucket worst);
    void fetchAhead() const;
    void collectDestroyed(PackedPoint apex);
    void fillBuckets(std::span<const std::uint32_t> slots);
    std::uint32_t takeBucketNumber();
    std::span<const PointBucket> buckets() const { return {buckets_.data(), bucketCount_}; }
    bool counts(float error) const { return error > options_.stopError; }
    std::uint64_t wholeIndex(PackedPoint point) const;

    LatticeBoxOptions options_;
    const LatticeSamples* samples_ = nullptr;
    HistorySink* sink_ = nullptr;
    PackedLattice lattice_{{2, 2, 2}};
    LatticeDelaunay delaunay_;
    PointPool pool_;
    ReservedArray<PointBucket> buckets_;
    std::uint32_t bucketCount_ = 0; ///< in use or once used
    std::vector<std::uint32_t> freeBuckets_;
    ErrorQueue queue_;
    ReservedArray<SlotState> slots_;
    Star startStar_;
    Redistribution redistribution_;
    std::uint64_t pointsAboveStop_ = 0; ///< points in tetrahedra that must still be refined: what is left to do
    std::uint32_t siteCount_ = 0;
    std::uint64_t tetrahedronCount_ = 0;

    Buffer<PackedPoint> points_;
    Buffer<std::uint32_t> filledFaces_;
    Buffer<std::uint32_t> places_;
    std::vector<std::uint32_t> destroyedHistory_;
    std::vector<std::uint32_t> destroyedBuckets_;
    std::vector<HistoryTetrahedron> starHistory_;
    std::array<float, LatticeDelaunay::startCount> startErrors_{};
};

LatticeRefiner::LatticeRefiner() = default;
LatticeRefiner::~LatticeRefiner() = default;
LatticeRefiner::LatticeRefiner(LatticeRefiner&&) noexcept = default;
LatticeRefiner& LatticeRefiner::operator=(LatticeRefiner&&) noexcept = default;

Result<LatticeRefinementResult> LatticeRefiner::refine(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                                       HistorySink& sink, const Progress& progress)
{
    if (Status status = checkBox(options); !status)
        return status.error();
    try {
        if (!state_)
            state_ = std::make_unique<State>();
        const bool whole = options.box.size == options.latticeSize;
        return state_->run(options,
                           whole ? samples : samples.copyBox(options.latticeSize, options.box, state_->boxSamples),
                           sink, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory to refine this lattice. Close other programs, use a "
                                               "machine with more memory, or crop or subsample the data."};
    }
}

Result<LatticeRefinementResult> refineLattice(const LatticeRefinementOptions& options, const LatticeSamples& samples,
                                              HistorySink& sink, const Progress& progress)
{
    const Result<LatticeMetric> metric = latticeMetric(options.size, options.spacing);
    if (!metric)
        return metric.error();
    LatticeBoxOptions whole;
    whole.latticeSize = options.size;
    whole.box = {{0, 0, 0}, options.size};
    whole.metric = *metric;
    whole.valueExtent = options.valueExtent;
    whole.stopError = options.stopError;
    return LatticeRefiner().refine(whole, samples, sink, progress);
}

Result<LatticeRefinementResult> LatticeRefiner::State::run(const LatticeBoxOptions& options,
                                                           const LatticeSamples& samples, HistorySink& sink,
                                                           const Progress& progress)
{
    options_ = options;
    samples_ = &samples;
    sink_ = &sink;
    progress.report(0, "Distributing the points");
    if (Status status = start(); !status)
        return status.error();
    return refine(progress);
}

Status LatticeRefiner::State::distributeStart()
{
    std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount> inside;
    const auto& size = options_.box.size;
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
    Star& star = startStar_;
    if (Status status = star.attach(lattice_); !status)
        return status;
    for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
        const auto& vertices = delaunay_[slot].vertices;
        star.set(vertices[0], {{{vertices[1], vertices[2], vertices[3]}}}, {1, 1, 1});
        slots_[slot].bucket = none;
        startErrors_[slot] = 0;
        if (inside[slot].empty())
            continue;
        redistribution_.run(lattice_, *samples_, star, inside[slot]);
        fillBuckets({&slot, 1});
        startErrors_[slot] = redistribution_.worstError(0);
        std::vector<PackedPoint>().swap(inside[slot]);
    }
    return {};
}

/// Hands the eight corners and the five tetrahedra to the sink, each tetrahedron with the latest of its corners.
Status LatticeRefiner::State::addCorners()
{
    const auto& size = options_.box.size;
    std::array<PackedPoint, 8> points{};
    for (std::uint32_t corner = 0; corner < points.size(); ++corner) {
        points[corner] = lattice_.pack((corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1),
                                       (corner >> 2 & 1) * (size[2] - 1));
        delaunay_.label(points[corner], corner);
    }
    for (const PackedPoint point : points) {
        starHistory_.clear();
        for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
            std::array<std::uint32_t, 4> sites{};
            for (std::size_t i = 0; i < 4; ++i)
                sites[i] =
                    static_cast<std::uint32_t>(std::ranges::find(points, delaunay_[slot].vertices[i]) - points.begin());
            const auto latest = static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin());
            if (sites[latest] != siteCount_)
                continue;
            const auto& [a, b, c] = cornersOfFace[latest];
            starHistory_.push_back({{sites[a], sites[b], sites[c]}, startErrors_[slot]});
            slots_[slot].history = static_cast<std::uint32_t>(tetrahedronCount_++);
        }
        if (Status status = sink_->add({wholeIndex(point), std::numeric_limits<float>::infinity(), starHistory_, {}});
            !status)
            return status;
        ++siteCount_;
    }
    return {};
}

Status LatticeRefiner::State::start()
{
    const auto& size = options_.box.size;
    if (Status status = delaunay_.start(size, options_.metric, options_.centreAtOrigin); !status)
        return status;
    lattice_ = delaunay_.lattice();
    queue_.start(roundedUp(options_.valueExtent));
    bucketCount_ = 0;
    freeBuckets_.clear();
    pointsAboveStop_ = 0;
    siteCount_ = 0;
    tetrahedronCount_ = 0;
    const std::uint64_t pointCount = std::uint64_t(size[0]) * size[1] * size[2];
    if (Status status = pool_.reserve(pointCount); !status)
        return status;
    if (Status status = buckets_.ensure(pointCount, "the lists of the refinement's points"); !status)
        return status;
    if (Status status = slots_.ensure(delaunay_.capacity(), "the state of the refinement's tetrahedra"); !status)
        return status;
    if (Status status = distributeStart(); !status)
        return status;
    return addCorners();
}

/// The point's number in the whole lattice.
std::uint64_t LatticeRefiner::State::wholeIndex(PackedPoint point) const
{
    const auto& origin = options_.box.origin;
    const std::uint64_t x = origin[0] + static_cast<std::uint32_t>(lattice_.x(point));
    const std::uint64_t y = origin[1] + static_cast<std::uint32_t>(lattice_.y(point));
    const std::uint64_t z = origin[2] + static_cast<std::uint32_t>(lattice_.z(point));
    return (z * options_.latticeSize[1] + y) * options_.latticeSize[0] + x;
}

std::uint32_t LatticeRefiner::State::takeBucketNumber()
{
    if (freeBuckets_.empty())
        return bucketCount_++;
    const std::uint32_t number = freeBuckets_.back();
    freeBuckets_.pop_back();
    return number;
}

/// Makes the buckets of `slots` out of what the relocation placed into the tetrahedra of its star.
TETRA_SIMD_CLONES void LatticeRefiner::State::fillBuckets(std::span<const std::uint32_t> slots)
{
    // Which tetrahedra have points at all is told without a branch, because nobody could predict it.
    std::size_t filledCount = 0;
    filledFaces_.resize(slots.size());
    for (std::uint32_t face = 0; face < slots.size(); ++face) {
        filledFaces_[filledCount] = face;
        filledCount += redistribution_.count(face) > 0;
    }
    places_.resize(slots.size());
    for (const std::uint32_t face : std::span(filledFaces_).first(filledCount)) {
        const std::uint32_t count = redistribution_.count(face);
        const std::uint32_t number = takeBucketNumber();
        PointBucket& bucket = buckets_[number];
        bucket = {count, count > 1 ? pool_.allocate(count) : PointPool::nowhere, redistribution_.worstPoint(face),
                  redistribution_.worstError(face), slots[face]};
        places_[face] = bucket.place;
        slots_[slots[face]].bucket = number;
        if (bucket.error > 0)
            queue_.push(number, bucket);
        if (counts(bucket.error))
            pointsAboveStop_ += count;
    }
    const std::span<const std::int32_t> owners = redistribution_.owners();
    for (std::size_t i = 0; i < owners.size(); ++i)
        pool_.put(places_[static_cast<std::size_t>(owners[i])]++, redistribution_.points()[i]);
}

/// Takes the points of the last insertion's cavity, without `apex`, and the history numbers of what it destroyed, and
/// gives the buckets back.
TETRA_SIMD_CLONES void LatticeRefiner::State::collectDestroyed(PackedPoint apex)
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
void LatticeRefiner::State::fetchAhead() const
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

Status LatticeRefiner::State::insertWorst(PointBucket worst)
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
        redistribution_.run(lattice_, *samples_, star, points_);
        fillBuckets(created);
        for (std::size_t face = 0; face < created.size(); ++face)
            starHistory_[face].error = redistribution_.worstError(face);
    }
    tetrahedronCount_ += star.faceCount();
    ++siteCount_;
    return sink_->add({wholeIndex(point), keyBefore, starHistory_, destroyedHistory_});
}

Result<LatticeRefinementResult> LatticeRefiner::State::refine(const Progress& progress)
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
