// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_mesh.h"

#include "core/base/rounding.h"
#include "core/base/simd.h"
#include "core/mesh/topology.h"
#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/refine/greedy.h"
#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/point_location.h"
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

/// An error or a warping as a float, not rounded down; 0 if it cannot be told from none.
float boundOf(double value, double least)
{
    return value <= least ? 0.0f : roundedUp(value);
}

/// Of the tetrahedron with `point` in place of the first vertex; an integer.
double sixfoldVolume(const PackedLattice& lattice, PackedPoint point, const std::array<PackedPoint, 4>& vertices)
{
    const auto from = [&](PackedPoint to) {
        return std::array<std::int64_t, 3>{lattice.x(to) - lattice.x(point), lattice.y(to) - lattice.y(point),
                                           lattice.z(to) - lattice.z(point)};
    };
    const auto a = from(vertices[1]), b = from(vertices[2]), c = from(vertices[3]);
    return static_cast<double>(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                               a[2] * (b[0] * c[1] - b[1] * c[0]));
}

} // namespace

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
    const std::uint64_t pointCount = options_.box.pointCount();
    // Six to seven tetrahedra a vertex are alive at once; room to spare.
    const std::uint64_t slots = std::min<std::uint64_t>(10 * pointCount + 64 + 4096, 0xfffffff0);
    if (Status status = delaunay_.prepare(options_.box.size, {1, 1, 1}, slots); !status)
        return status;
    if (Status status = pool_.reserve(pointCount); !status)
        return status;
    if (Status status =
            slots_.ensure(delaunay_.capacity(), Message::marked("the state of the refinement's tetrahedra"));
        !status)
        return status;
    return startStar_.attach(grid_->lattice());
}

Status CurvilinearMesh::start(const CurvilinearGrid& grid, const Options& options, HistorySink& sink)
{
    grid_ = &grid;
    options_ = options;
    anyShared_ = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        shared_[axis] = {options.box.origin[axis] > 0, options.box.last(axis) + 1 < options.size[axis]};
        anyShared_ = anyShared_ || shared_[axis][0] || shared_[axis][1];
    }
    queue_.start(roundedUp(std::max(options.largestError, options.warpingWeight * options.largestWarping)));
    warpingQueue_.start(roundedUp(options.largestWarping));
    buckets_.clear();
    warpingBuckets_.clear();
    freeBuckets_.clear();
    flips_.clear();
    inverted_ = 0;
    degenerate_ = 0;
    pointsAboveStop_ = 0;
    points_.clear();
    if (Status status = reserve(); !status)
        return status;
    const LatticeBox whole{{0, 0, 0}, options.box.size};
    hint_ = delaunay_.addBox(whole, options.centreAtOrigin);
    auto inside = pointsOfStart(delaunay_, whole, hint_);
    for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
        distribute(slot, inside[slot]);
        std::vector<PackedPoint>().swap(inside[slot]);
    }
    if (Status status = addCorners(sink); !status)
        return status;
    for (std::uint32_t slot = 0; slot < delaunay_.slotCount(); ++slot)
        noteOrientation(slot);
    return {};
}

void CurvilinearMesh::archive(StateArchive& archive)
{
    archive(delaunay_, pool_, buckets_, warpingBuckets_, freeBuckets_, queue_, warpingQueue_, flips_, siteCount_,
            tetrahedronCount_, inverted_, degenerate_, pointsAboveStop_, hint_, nextSlot_);
    archive.elements(std::span(slots_.data(), delaunay_.slotCount()));
}

/// Gives the points to a tetrahedron of the start that they lie in.
void CurvilinearMesh::distribute(std::uint32_t slot, std::span<const PackedPoint> points)
{
    const auto& vertices = delaunay_[slot].vertices;
    startStar_.set(vertices[0], {{{vertices[1], vertices[2], vertices[3]}}}, {1, 1, 1});
    redistribution_.run(*grid_, startStar_, points);
    slots_[slot] = {};
    startAccuracies_[slot] = fillBucket(slot, 0, delaunay_[slot].determinant());
}

/// The corners are the first sites.
Status CurvilinearMesh::addCorners(HistorySink& sink)
{
    std::array<PackedPoint, 8> corners{};
    std::array<std::uint64_t, 8> points{};
    for (std::uint32_t number = 0; number < corners.size(); ++number) {
        const auto corner = LatticeBox{{0, 0, 0}, options_.box.size}.corner(number);
        corners[number] = grid_->lattice().pack(corner[0], corner[1], corner[2]);
        points[number] = wholeIndex(corners[number]);
        delaunay_.label(corners[number], number);
    }
    std::array<StartTetrahedron, LatticeDelaunay::startCount> tetrahedra;
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot) {
        tetrahedra[slot].error = startAccuracies_[slot].error;
        tetrahedra[slot].warping = startAccuracies_[slot].warping;
        for (std::size_t i = 0; i < 4; ++i)
            tetrahedra[slot].sites[i] =
                static_cast<std::uint32_t>(std::ranges::find(corners, delaunay_[slot].vertices[i]) - corners.begin());
    }
    const auto numbers = addStart(points, tetrahedra, sink);
    if (!numbers)
        return numbers.error();
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot)
        slots_[slot].history = (*numbers)[slot];
    siteCount_ = points.size();
    tetrahedronCount_ = tetrahedra.size();
    return {};
}

std::uint64_t CurvilinearMesh::wholeIndex(PackedPoint point) const noexcept
{
    const PackedLattice& lattice = grid_->lattice();
    const auto& origin = options_.box.origin;
    const std::uint64_t x = origin[0] + static_cast<std::uint32_t>(lattice.x(point));
    const std::uint64_t y = origin[1] + static_cast<std::uint32_t>(lattice.y(point));
    const std::uint64_t z = origin[2] + static_cast<std::uint32_t>(lattice.z(point));
    return (z * options_.size[1] + y) * options_.size[0] + x;
}

bool CurvilinearMesh::isShared(PackedPoint point) const noexcept
{
    if (!anyShared_)
        return false;
    const PackedLattice& lattice = grid_->lattice();
    const std::array<std::int32_t, 3> at{lattice.x(point), lattice.y(point), lattice.z(point)};
    bool shared = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
        shared |= (shared_[axis][0] && at[axis] == 0) ||
                  (shared_[axis][1] && at[axis] + 1 == static_cast<std::int32_t>(options_.box.size[axis]));
    return shared;
}

/// The accuracy of a point on a face that other blocks have too, the same bits in all of them: of the vertices only
/// those count whose weight is not 0, which are on the face, in the order of the grid; and weights are quotients of
/// integers, correctly rounded whatever they were reduced by.
CurvilinearMesh::Accuracy CurvilinearMesh::accuracyOnFace(std::uint32_t slot, PackedPoint point) const
{
    const PackedLattice& lattice = grid_->lattice();
    std::array<PackedPoint, 4> vertices = delaunay_[slot].vertices;
    const double whole = delaunay_[slot].determinant();
    std::array<std::pair<PackedPoint, double>, 4> weights;
    for (std::size_t i = 0; i < 4; ++i)
        weights[i] = {vertices[i], sixfoldVolume(lattice, point, withCornerFirst(vertices, i)) / whole};
    std::ranges::sort(weights);
    const PhysicalPoint& at = grid_->at(point);
    std::array<double, 4> residual{};
    for (const auto& [vertex, weight] : weights) {
        if (weight == 0)
            continue;
        const PhysicalPoint& corner = grid_->at(vertex);
        for (std::size_t i = 0; i < 4; ++i)
            residual[i] += weight * (corner.components[i] - at.components[i]);
    }
    const double weight = grid_->weighted() ? grid_->weight(point) : 1.0;
    Accuracy accuracy;
    accuracy.error = boundOf(weight * std::abs(residual[3]), grid_->leastError());
    accuracy.warping =
        boundOf(weight * std::sqrt(residual[0] * residual[0] + residual[1] * residual[1] + residual[2] * residual[2]),
                grid_->leastWarping());
    accuracy.key = keyOf(accuracy.error, accuracy.warping);
    return accuracy;
}

/// What is worst of what the relocation placed into `face` of the star: the tetrahedron of `slot`.
CurvilinearMesh::WorstPoints CurvilinearMesh::worstOf(std::uint32_t slot, std::size_t face, double determinant) const
{
    const std::uint32_t first = redistribution_.offsets()[face];
    const std::uint32_t count = redistribution_.offsets()[face + 1] - first;
    const std::span<const PackedPoint> points = redistribution_.placed().subspan(first, count);
    const double* const errors = redistribution_.scaledSquaredErrors().data() + first;
    const double* const warpings = redistribution_.scaledSquaredWarpings().data() + first;
    const double squaredWeight = options_.warpingWeight * options_.warpingWeight;
    Worst error, warping, key;
    WorstPoints onFaces;
    bool anyOnFaces = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (isShared(points[i])) {
            const Accuracy own = accuracyOnFace(slot, points[i]);
            if (!anyOnFaces || own.key > onFaces.accuracy.key ||
                (own.key == onFaces.accuracy.key && points[i] < onFaces.byKey)) {
                onFaces.accuracy.key = own.key;
                onFaces.byKey = points[i];
            }
            onFaces.accuracy.error = std::max(onFaces.accuracy.error, own.error);
            onFaces.accuracy.warping = std::max(onFaces.accuracy.warping, own.warping);
            anyOnFaces = true;
            continue;
        }
        error.take(errors[i], points[i]);
        warping.take(warpings[i], points[i]);
        key.take(std::max(errors[i], squaredWeight * warpings[i]), points[i]);
    }
    if (key.measure < 0)
        return onFaces;
    const auto bound = [determinant](double scaledSquare, double least) {
        return boundOf(std::sqrt(scaledSquare) / determinant, least);
    };
    WorstPoints worst{{bound(error.measure, grid_->leastError()), bound(warping.measure, grid_->leastWarping()), 0},
                      key.point,
                      error.point,
                      warping.point};
    worst.accuracy.key = keyOf(worst.accuracy.error, worst.accuracy.warping);
    if (anyOnFaces) {
        const float inside = worst.accuracy.key, onFace = onFaces.accuracy.key;
        if (onFace > inside || (onFace == inside && onFaces.byKey < worst.byKey))
            worst.byKey = onFaces.byKey;
        worst.accuracy = {std::max(worst.accuracy.error, onFaces.accuracy.error),
                          std::max(worst.accuracy.warping, onFaces.accuracy.warping), std::max(inside, onFace)};
    }
    return worst;
}

/// Makes the bucket of `slot` out of what the relocation placed into `face` of its star.
CurvilinearMesh::Accuracy CurvilinearMesh::fillBucket(std::uint32_t slot, std::size_t face, double determinant)
{
    const std::uint32_t first = redistribution_.offsets()[face];
    const std::uint32_t count = redistribution_.offsets()[face + 1] - first;
    if (count == 0)
        return {};
    const std::span<const PackedPoint> points = redistribution_.placed().subspan(first, count);
    const WorstPoints worst = worstOf(slot, face, determinant);
    const Accuracy& accuracy = worst.accuracy;

    const std::uint32_t number = takeBucketNumber();
    slots_[slot].bucket = number;
    PointBucket& bucket = buckets_[number];
    bucket = {count, 0, worst.byKey, accuracy.key, slot};
    if (count > 1) {
        bucket.place = pool_.allocate(count);
        std::ranges::copy(points, pool_.points(bucket.place, count).begin());
    }
    if (accuracy.key > options_.stopKey)
        pointsAboveStop_ += count;
    if (options_.selection == CurvilinearSelection::Paper) {
        warpingBuckets_[number] = {count, bucket.place, worst.byWarping, accuracy.warping, slot};
        if (accuracy.warping > 0)
            warpingQueue_.push(number, warpingBuckets_[number]);
        bucket.worst = worst.byError;
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
    state.orientation = grid_->orientation(tetrahedron.vertices);
    degenerate_ += state.orientation == 0;
    if (state.orientation >= 0)
        return;
    ++inverted_;
    if (!grid_->allowsInverted(tetrahedron.vertices))
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
    const PackedPoint point = candidate.point;
    starHistory_.clear();
    destroyedHistory_.clear();
    if (!delaunay_.insert(point, candidate.slot))
        return Error{ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
    for (const std::uint32_t destroyed : delaunay_.destroyed())
        __builtin_prefetch(&slots_[destroyed]);
    delaunay_.prefetchNeighbours(nextSlot_);
    collectDestroyed();
    const Star& star = delaunay_.star();
    const std::span<const std::uint32_t> rimSites = star.labels();
    delaunay_.label(point, siteCount_++);
    const bool hasPoints = points_.size() > 1;
    if (hasPoints)
        redistribution_.run(*grid_, star, points_);
    for (std::size_t face = 0; face < star.faceCount(); ++face) {
        const std::uint32_t created = delaunay_.created()[face];
        slots_[created] = {static_cast<std::uint32_t>(tetrahedronCount_++), none, 1};
        const Accuracy accuracy = hasPoints ? fillBucket(created, face, star.faces()[face].determinant()) : Accuracy{};
        noteOrientation(created);
        const std::array<std::uint32_t, 3>& corners = star.corners()[face];
        starHistory_.push_back(
            {{rimSites[corners[0]], rimSites[corners[1]], rimSites[corners[2]]}, accuracy.error, accuracy.warping});
    }
    hint_ = delaunay_.created()[0];
    return sink.add({wholeIndex(point), keyBefore, starHistory_, destroyedHistory_});
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
    const PackedLattice& lattice = grid_->lattice();
    // A point that no other block has needs nobody's consent.
    LatticeBox own{{0, 0, 0}, options_.box.size};
    bool ownAny = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t taken = (shared_[axis][0] ? 1u : 0u) + (shared_[axis][1] ? 1u : 0u);
        ownAny = ownAny && own.size[axis] > taken;
        own.origin[axis] = shared_[axis][0] ? 1 : 0;
        own.size[axis] -= taken;
    }
    std::optional<PackedPoint> cure;
    if (ownAny)
        cure = deepestPointInSphere(lattice, delaunay_[slot], own);
    if (!cure && anyShared_)
        cure = deepestPointInSphere(lattice, delaunay_[slot], {{0, 0, 0}, options_.box.size});
    assert(cure); // it is not of one cell
    return {*cure, slot, 0};
}

CurvilinearMesh::Candidate CurvilinearMesh::at(std::uint64_t wholePoint)
{
    const std::uint64_t row = wholePoint / options_.size[0];
    const auto& origin = options_.box.origin;
    const PackedPoint point =
        grid_->lattice().pack(static_cast<std::uint32_t>(wholePoint % options_.size[0]) - origin[0],
                              static_cast<std::uint32_t>(row % options_.size[1]) - origin[1],
                              static_cast<std::uint32_t>(row / options_.size[1]) - origin[2]);
    const std::uint32_t slot = walkByFirstFace(delaunay_, point, hint_);
    if (std::ranges::find(delaunay_[slot].vertices, point) != delaunay_[slot].vertices.end())
        return {};
    return {point, slot, 0};
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
