// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_mesh.h"

#include "core/base/rounding.h"
#include "core/base/simd.h"
#include "core/base/sort_unique.h"
#include "core/mesh/topology.h"
#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/refine/greedy.h"
#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/star.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace tetra {

void StarPlacement::gatherCoordinates(const PackedLattice& lattice, PackedPoint apex,
                                      std::span<const PackedPoint> points)
{
    points_.resize(points.size());
    std::size_t count = 0;
    for (const PackedPoint point : points) {
        points_[count] = point;
        count += point != apex;
    }
    points_.resize(count);
    const std::size_t padded = (count + coneSearchLanes - 1) / coneSearchLanes * coneSearchLanes;
    x_.resize(padded);
    y_.resize(padded);
    z_.resize(padded);
    owners_.resize(padded);
    const std::int32_t apexX = lattice.x(apex), apexY = lattice.y(apex), apexZ = lattice.z(apex);
    for (std::size_t i = 0; i < count; ++i) {
        x_[i] = static_cast<float>(lattice.x(points_[i]) - apexX);
        y_[i] = static_cast<float>(lattice.y(points_[i]) - apexY);
        z_[i] = static_cast<float>(lattice.z(points_[i]) - apexZ);
    }
}

void StarPlacement::sortByOwner(std::size_t faceCount)
{
    offsets_.assign(faceCount + 2, 0);
    for (std::size_t i = 0; i < points_.size(); ++i)
        ++offsets_[static_cast<std::size_t>(owners_[i]) + 2];
    for (std::size_t face = 2; face < offsets_.size(); ++face)
        offsets_[face] += offsets_[face - 1];
    placed_.resize(points_.size());
    placedCoordinates_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const std::uint32_t place = offsets_[static_cast<std::size_t>(owners_[i]) + 1]++;
        placed_[place] = points_[i];
        placedCoordinates_[place] = {x_[i], y_[i], z_[i], 0};
    }
    offsets_.pop_back();
}

void StarPlacement::run(const PackedLattice& lattice, const Star& star, std::span<const PackedPoint> points)
{
    // The first insertions move millions of points, the later ones dozens: give the room of the first back.
    constexpr std::size_t roomWorthKeeping = 65536;
    if (points_.capacity() > std::max(roomWorthKeeping, 16 * points.size()))
        *this = StarPlacement();
    gatherCoordinates(lattice, star.apex(), points);
    locateInStar(star, {x_, y_, z_}, planes_, owners_);
    sortByOwner(star.faceCount());
}

namespace {

/// The physical vertices of one tetrahedron and what a point's place in it needs.
struct PhysicalFace {
    const Star::Face& face;
    const PhysicalPoint& apex;
    const PhysicalPoint& a;
    const PhysicalPoint& b;
    const PhysicalPoint& c;
};

struct PlacedPoints {
    const PackedPoint* points;
    const std::array<float, 4>* coordinates;
    std::size_t count;
};

TETRA_SIMD_INLINE void measure(const CurvilinearGrid& grid, const PhysicalFace& physical, const PlacedPoints& placed,
                               double* squaredErrors, double* squaredWarpings)
{
    const auto load = [](Double4& to, const PhysicalPoint& from) { std::memcpy(&to, &from, sizeof to); };
    Double4 apex, a, b, c;
    load(apex, physical.apex);
    load(a, physical.a);
    load(b, physical.b);
    load(c, physical.c);
    a -= apex;
    b -= apex;
    c -= apex;
    const Star::Face& face = physical.face;
    const Double4 slopeX = a * face.normals[0] + b * face.normals[4] + c * face.normals[8];
    const Double4 slopeY = a * face.normals[1] + b * face.normals[5] + c * face.normals[9];
    const Double4 slopeZ = a * face.normals[2] + b * face.normals[6] + c * face.normals[10];
    const double determinant = face.determinant();
    for (std::size_t i = 0; i < placed.count; ++i) {
        Double4 point;
        load(point, grid.at(placed.points[i]));
        const std::array<float, 4>& at = placed.coordinates[i];
        const Double4 residual =
            determinant * (point - apex) - slopeX * double(at[0]) - slopeY * double(at[1]) - slopeZ * double(at[2]);
        const Double4 squares = residual * residual;
        squaredErrors[i] = squares[3];
        squaredWarpings[i] = squares[0] + squares[1] + squares[2];
    }
}

} // namespace

void CurvilinearRedistribution::weigh(const CurvilinearGrid& grid)
{
    for (std::size_t i = 0; i < placed().size(); ++i) {
        const double weight = grid.weight(placed()[i]);
        squaredErrors_[i] *= weight * weight;
        squaredWarpings_[i] *= weight * weight;
    }
}

void CurvilinearRedistribution::run(const CurvilinearGrid& grid, const Star& star, std::span<const PackedPoint> points)
{
    placement_.run(grid.lattice(), star, points);
    link_.resize(star.link().size());
    for (std::size_t i = 0; i < link_.size(); ++i)
        link_[i] = grid.at(star.link()[i]);
    squaredErrors_.resize(placed().size());
    squaredWarpings_.resize(placed().size());
    for (std::size_t f = 0; f < star.faceCount(); ++f) {
        const std::uint32_t first = offsets()[f];
        const std::uint32_t count = offsets()[f + 1] - first;
        if (count == 0)
            continue;
        const std::array<std::uint32_t, 3>& corners = star.corners()[f];
        const PhysicalFace physical{star.faces()[f], grid.at(star.apex()), link_[corners[0]], link_[corners[1]],
                                    link_[corners[2]]};
        dispatch<measure>(grid, physical, {placed().data() + first, placement_.coordinates().data() + first, count},
                          squaredErrors_.data() + first, squaredWarpings_.data() + first);
    }
    if (grid.weighted())
        weigh(grid);
}

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

CurvilinearMesh::CurvilinearMesh(const CurvilinearGrid& grid, const BlockDivision& blocks, const Options& options)
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

Status CurvilinearMesh::reserve()
{
    const auto& size = grid_.lattice().size();
    std::uint64_t blockPoints = 0;
    for (std::uint32_t block = 0; block < blocks_.count(); ++block)
        blockPoints += blocks_.box(block).pointCount();
    // Six to seven tetrahedra a vertex are alive at once; room to spare.
    const std::uint64_t slots =
        std::min<std::uint64_t>(10 * blockPoints + 64 * std::uint64_t(blocks_.count()) + 4096, 0xfffffff0);
    if (Status status = delaunay_.prepare(size, {1, 1, 1}, slots); !status)
        return status;
    if (Status status = pool_.reserve(blockPoints); !status)
        return status;
    if (Status status =
            slots_.reserve(delaunay_.capacity(), Message::marked("the state of the refinement's tetrahedra"));
        !status)
        return status;
    if (Status status = startStar_.attach(grid_.lattice()); !status)
        return status;
    const std::uint64_t pointCount = std::uint64_t(size[0]) * size[1] * size[2];
    return siteOfPoint_.reserve(pointCount, Message::marked("the numbers of the sites"));
}

Status CurvilinearMesh::start(HistorySink& sink)
{
    if (Status status = reserve(); !status)
        return status;
    for (std::uint32_t block = 0; block < blocks_.count(); ++block) {
        hints_.push_back(delaunay_.addBox(blocks_.box(block), !blocks_.odd(block)));
        distribute(block, hints_.back());
    }
    if (Status status = addCorners(sink); !status)
        return status;
    for (std::uint32_t slot = 0; slot < delaunay_.slotCount(); ++slot)
        noteOrientation(slot);
    return {};
}

/// Gives every point of the block but its corners to one of the five tetrahedra of its start.
void CurvilinearMesh::distribute(std::uint32_t block, std::uint32_t firstSlot)
{
    auto inside = pointsOfStart(delaunay_, blocks_.box(block), firstSlot);
    for (std::uint32_t number = 0; number < LatticeDelaunay::startCount; ++number) {
        const std::uint32_t slot = firstSlot + number;
        const auto& vertices = delaunay_[slot].vertices;
        startStar_.set(vertices[0], {{{vertices[1], vertices[2], vertices[3]}}}, {1, 1, 1});
        redistribution_.run(grid_, startStar_, inside[number]);
        slots_[slot] = {none, none, block, 1};
        startAccuracies_.push_back(fillBucket(slot, 0, delaunay_[slot].determinant()));
        std::vector<PackedPoint>().swap(inside[number]);
    }
}

/// The corners of all blocks, each once, are the first sites.
Status CurvilinearMesh::addCorners(HistorySink& sink)
{
    std::vector<std::uint64_t> corners;
    for (std::uint32_t block = 0; block < blocks_.count(); ++block)
        for (std::uint32_t number = 0; number < 8; ++number) {
            const auto corner = blocks_.box(block).corner(number);
            corners.push_back(index(grid_.lattice().pack(corner[0], corner[1], corner[2])));
        }
    sortUnique(corners);
    for (std::uint32_t site = 0; site < corners.size(); ++site)
        siteOfPoint_[corners[site]] = site + 1;

    std::vector<StartTetrahedron> tetrahedra(delaunay_.slotCount());
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot) {
        tetrahedra[slot].error = startAccuracies_[slot].error;
        tetrahedra[slot].warping = startAccuracies_[slot].warping;
        for (std::size_t i = 0; i < 4; ++i)
            tetrahedra[slot].sites[i] = siteOfPoint_[index(delaunay_[slot].vertices[i])] - 1;
    }
    const auto numbers = addStart(corners, tetrahedra, sink);
    if (!numbers)
        return numbers.error();
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot)
        slots_[slot].history = (*numbers)[slot];
    siteCount_ = static_cast<std::uint32_t>(corners.size());
    tetrahedronCount_ = tetrahedra.size();
    return {};
}

/// Makes the bucket of `slot` out of what the relocation placed into `face` of its star.
CurvilinearMesh::Accuracy CurvilinearMesh::fillBucket(std::uint32_t slot, std::size_t face, double determinant)
{
    const std::uint32_t first = redistribution_.offsets()[face];
    const std::uint32_t count = redistribution_.offsets()[face + 1] - first;
    if (count == 0)
        return {};
    const std::span<const PackedPoint> points = redistribution_.placed().subspan(first, count);
    const double* const errors = redistribution_.scaledSquaredErrors().data() + first;
    const double* const warpings = redistribution_.scaledSquaredWarpings().data() + first;
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
    if (!grid_.allowsInverted(tetrahedron.vertices))
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
    rimSites_.resize(star.link().size());
    for (std::size_t i = 0; i < rimSites_.size(); ++i)
        rimSites_[i] = siteOfPoint_[index(star.link()[i])] - 1;
    const bool hasPoints = points_.size() > 1;
    if (hasPoints)
        redistribution_.run(grid_, star, points_);
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
            return Error{ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
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
