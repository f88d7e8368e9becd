// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/lattice_refinement.h"

#include "core/base/guarded.h"
#include "core/base/rounding.h"
#include "core/refine/greedy.h"
#include "core/refine/lattice/error_queue.h"
#include "core/refine/lattice/point_pool.h"
#include "core/refine/lattice/redistribution.h"
#include "core/refine/noted_history.h"

#include <algorithm>
#include <span>
#include <vector>

namespace tetra {

namespace {

Status checkBox(const LatticeBoxOptions& options)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (options.box.size[axis] < 2 || options.box.size[axis] > options.latticeSize[axis] ||
            options.box.origin[axis] > options.latticeSize[axis] - options.box.size[axis])
            return Error{ErrorKind::WrongUsage,
                         Message::say("A block of the lattice needs at least two points along each axis and must lie "
                                      "within it. Choose another block size.")};
    if (!exactWithMetric(options.box.size, options.metric))
        return Error{ErrorKind::OutOfResource, Message::say("A block of the lattice is too large to be refined with "
                                                            "exact arithmetic. Choose a smaller block size.")};
    return {};
}

} // namespace

/// The space of a lattice (core/refine/greedy.h), of one box after another in the same memory: the mesh, the buckets of
/// points inside its tetrahedra, and the queue of their errors. One thread. Allocations throw std::bad_alloc.
class LatticeRefiner::State {
public:
    /// `samples` are those of the box alone. After an error the next run starts afresh.
    Result<LatticeRefinementResult> run(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                        HistorySink& sink, const Progress& progress);

    Buffer<std::byte> boxSamples; ///< room for those of a box

    struct Next {
        PointBucket bucket;
        float key = 0;
        static constexpr bool complete = true;
    };
    Next next();
    Status insert(const Next& next);
    std::uint64_t work() const { return 200 + points_.size(); }
    std::uint64_t pointsAboveStop() const { return pointsAboveStop_; }
    void sweep();
    void archive(StateArchive& archive);

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
    const auto refineBox = [&] {
        if (!state_)
            state_ = std::make_unique<State>();
        const bool whole = options.box.size == options.latticeSize;
        return state_->run(options,
                           whole ? samples : samples.copyBox(options.latticeSize, options.box, state_->boxSamples),
                           sink, progress);
    };
    return guarded(
        Message::marked(
            "Not enough memory to refine this lattice. Close other programs, use a machine with more memory, or "
            "crop or subsample the data."),
        refineBox);
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
    whole.state = options.state;
    return LatticeRefiner().refine(whole, samples, sink, progress);
}

Result<LatticeRefinementResult> LatticeRefiner::State::run(const LatticeBoxOptions& options,
                                                           const LatticeSamples& samples, HistorySink& sink,
                                                           const Progress& progress)
{
    options_ = options;
    samples_ = &samples;
    NotedHistory history(sink, options.state);
    sink_ = &history;
    progress.report(0, Message::marked("Distributing the points"));
    if (Status status = start(); !status)
        return status.error();
    if (Status status = history.goOn(*this, progress); !status)
        return status.error();
    const Result<float> key = refineWorstFirst(*this, options.stopError, history, progress, options.state);
    if (!key)
        return key.error();
    return LatticeRefinementResult{siteCount_, tetrahedronCount_, *key};
}

/// What changes after start().
void LatticeRefiner::State::archive(StateArchive& archive)
{
    archive(delaunay_, pool_, bucketCount_, freeBuckets_, queue_, pointsAboveStop_, siteCount_, tetrahedronCount_);
    archive.elements(std::span(buckets_.data(), bucketCount_));
    archive.elements(std::span(slots_.data(), delaunay_.slotCount()));
}

Status LatticeRefiner::State::distributeStart()
{
    auto inside = pointsOfStart(delaunay_, {{0, 0, 0}, options_.box.size}, 0);
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

Status LatticeRefiner::State::addCorners()
{
    const auto& size = options_.box.size;
    std::array<PackedPoint, 8> corners{};
    std::array<std::uint64_t, 8> points{};
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
        corners[corner] = lattice_.pack((corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1),
                                        (corner >> 2 & 1) * (size[2] - 1));
        points[corner] = wholeIndex(corners[corner]);
        delaunay_.label(corners[corner], corner);
    }
    std::array<StartTetrahedron, LatticeDelaunay::startCount> tetrahedra;
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot) {
        tetrahedra[slot].error = startErrors_[slot];
        for (std::size_t i = 0; i < 4; ++i)
            tetrahedra[slot].sites[i] =
                static_cast<std::uint32_t>(std::ranges::find(corners, delaunay_[slot].vertices[i]) - corners.begin());
    }
    const auto numbers = addStart(points, tetrahedra, *sink_);
    if (!numbers)
        return numbers.error();
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot)
        slots_[slot].history = (*numbers)[slot];
    siteCount_ = points.size();
    tetrahedronCount_ = tetrahedra.size();
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
    if (Status status = buckets_.ensure(pointCount, Message::marked("the lists of the refinement's points")); !status)
        return status;
    if (Status status =
            slots_.ensure(delaunay_.capacity(), Message::marked("the state of the refinement's tetrahedra"));
        !status)
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
void LatticeRefiner::State::fillBuckets(std::span<const std::uint32_t> slots)
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
void LatticeRefiner::State::collectDestroyed(PackedPoint apex)
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

LatticeRefiner::State::Next LatticeRefiner::State::next()
{
    const std::uint32_t number = queue_.top(buckets());
    return number == ErrorQueue::none ? Next{} : Next{buckets_[number], buckets_[number].error};
}

Status LatticeRefiner::State::insert(const Next& next)
{
    const PackedPoint point = next.bucket.worst;
    if (!delaunay_.insert(point, next.bucket.tetrahedron))
        return Error{ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
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
    return sink_->add({wholeIndex(point), next.key, starHistory_, destroyedHistory_});
}

void LatticeRefiner::State::sweep()
{
    if (queue_.entryCount() > 2 * (bucketCount_ - freeBuckets_.size()) + 65536)
        queue_.sweep(buckets());
}

} // namespace tetra
