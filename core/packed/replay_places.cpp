// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay_places.h"

#include "core/base/progress.h"
#include "core/base/simd.h"
#include "core/refine/lattice/lattice_delaunay.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <numeric>
#include <optional>

namespace tetra {

namespace {

constexpr MarkedText replayingBlocks = Message::marked("Replaying the insertions");

/// Walks of several points at a time, since each step of one waits for memory, always across the face that the point is
/// farthest beyond. `slots`: where they begin, and then the tetrahedra that have the points; none if that leads out of
/// the mesh.
TETRA_SIMD_INLINE void walkTogether(const LatticeDelaunay& mesh, const PackedPoint* points, std::uint32_t* slots,
                                    std::size_t count)
{
    constexpr std::size_t atOnce = 8;
    struct Walk {
        std::int32_t x, y, z;
        std::uint32_t slot;
        std::size_t number;
    };
    const PackedLattice lattice = mesh.lattice();
    std::array<Walk, atOnce> walks;
    std::size_t walking = 0, next = 0;
    const auto begin = [&](Walk& walk) {
        const PackedPoint point = points[next];
        walk = {lattice.x(point), lattice.y(point), lattice.z(point), slots[next], next};
        ++next;
        mesh.prefetch(walk.slot);
    };
    while (walking < atOnce && next < count)
        begin(walks[walking++]);
    while (walking > 0)
        for (std::size_t i = 0; i < walking;) {
            Walk& walk = walks[i];
            const DelaunayTetrahedron& tetrahedron = mesh[walk.slot];
            Int4 vertices, offsetX, offsetY, offsetZ;
            std::memcpy(&vertices, &tetrahedron.vertices, sizeof vertices);
            lattice.unpack(vertices, offsetX, offsetY, offsetZ);
            const Double4 x = __builtin_convertvector(offsetX - walk.x, Double4);
            const Double4 y = __builtin_convertvector(offsetY - walk.y, Double4);
            const Double4 z = __builtin_convertvector(offsetZ - walk.z, Double4);
            // Six times the volume of the point with the face opposite to each vertex: a . (b x c) of the other three.
            const Double4 firstX = __builtin_shufflevector(x, x, 1, 0, 3, 2),
                          firstY = __builtin_shufflevector(y, y, 1, 0, 3, 2),
                          firstZ = __builtin_shufflevector(z, z, 1, 0, 3, 2);
            const Double4 secondX = __builtin_shufflevector(x, x, 2, 3, 0, 1),
                          secondY = __builtin_shufflevector(y, y, 2, 3, 0, 1),
                          secondZ = __builtin_shufflevector(z, z, 2, 3, 0, 1);
            const Double4 thirdX = __builtin_shufflevector(x, x, 3, 2, 1, 0),
                          thirdY = __builtin_shufflevector(y, y, 3, 2, 1, 0),
                          thirdZ = __builtin_shufflevector(z, z, 3, 2, 1, 0);
            const Double4 volume = firstX * (secondY * thirdZ - secondZ * thirdY) +
                                   firstY * (secondZ * thirdX - secondX * thirdZ) +
                                   firstZ * (secondX * thirdY - secondY * thirdX);
            std::uint32_t least = 0;
            double leastVolume = volume[0];
            for (std::uint32_t face = 1; face < 4; ++face) {
                least = volume[face] < leastVolume ? face : least;
                leastVolume = std::min(leastVolume, volume[face]);
            }
            if (leastVolume < 0) {
                walk.slot = tetrahedron.neighbours[least];
                if (walk.slot != LatticeDelaunay::none) {
                    mesh.prefetch(walk.slot);
                    ++i;
                    continue;
                }
            }
            slots[walk.number] = walk.slot;
            if (next < count)
                begin(walks[i++]);
            else
                walks[i] = walks[--walking];
        }
}

} // namespace

/// The mesh of one block after the other.
class ReplayedBlock {
public:
    /// The mesh of the block's corners.
    Status start(const LatticeBox& box, const LatticeMetric& metric, bool odd);

    const PackedLattice& lattice() const noexcept { return mesh_.lattice(); }
    const LatticeDelaunay& mesh() const noexcept { return mesh_; }
    /// The tetrahedra that have points of the block's lattice. False if one lies in none.
    [[nodiscard]] bool place(std::span<const PackedPoint> points, std::vector<std::uint32_t>& slots);
    /// Adds points to the mesh that was asked where they lie, and calls added(i) after each. False if it has no room.
    template <class Added> [[nodiscard]] bool add(std::span<const PackedPoint> points,
                                                  std::span<const std::uint32_t> slots, const Added& added);
    void label(PackedPoint point, std::uint32_t number) { mesh_.label(point, number); }

private:
    /// A tetrahedron for each cell of a grid, the last that was made there. Where nothing was made in a cell, a larger
    /// one that has it tells.
    struct Hints {
        std::uint32_t bits;                   ///< of a coordinate that count within a cell
        std::array<std::size_t, 2> strides{}; ///< along y and z
        std::vector<std::uint32_t> tetrahedra{};
    };

    std::uint32_t& hintOf(Hints& hints, PackedPoint point) const
    {
        const PackedLattice& lattice = mesh_.lattice();
        const auto along = [&](std::int32_t coordinate) { return static_cast<std::size_t>(coordinate) >> hints.bits; };
        return hints.tetrahedra[along(lattice.z(point)) * hints.strides[1] +
                                along(lattice.y(point)) * hints.strides[0] + along(lattice.x(point))];
    }
    std::uint32_t startFor(PackedPoint point)
    {
        for (Hints& hints : hints_)
            if (const std::uint32_t hint = hintOf(hints, point);
                hint != LatticeDelaunay::none && mesh_[hint].determinant() != 0)
                return hint;
        return last_;
    }

    LatticeDelaunay mesh_;
    std::array<Hints, 3> hints_ = {Hints{1}, Hints{3}, Hints{5}};
    std::uint32_t last_ = 0; ///< that was made
};

Status ReplayedBlock::start(const LatticeBox& box, const LatticeMetric& metric, bool odd)
{
    if (const Status started = mesh_.start(box.size, metric, !odd); !started)
        return started;
    for (Hints& hints : hints_) {
        const auto cellsAlong = [&](std::size_t axis) { return std::size_t((box.size[axis] - 1) >> hints.bits) + 1; };
        hints.strides = {cellsAlong(0), cellsAlong(0) * cellsAlong(1)};
        hints.tetrahedra.assign(hints.strides[1] * cellsAlong(2), LatticeDelaunay::none);
    }
    last_ = LatticeDelaunay::startCount - 1;
    return {};
}

bool ReplayedBlock::place(std::span<const PackedPoint> points, std::vector<std::uint32_t>& slots)
{
    slots.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        slots[i] = startFor(points[i]);
    dispatch<walkTogether>(mesh_, points.data(), slots.data(), points.size());
    return std::ranges::find(slots, LatticeDelaunay::none) == slots.end();
}

template <class Added>
bool ReplayedBlock::add(std::span<const PackedPoint> points, std::span<const std::uint32_t> slots, const Added& added)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Waiting for memory is most of an insertion: what the next ones need is fetched step by step.
        if (i + 4 < points.size())
            mesh_.prefetch(slots[i + 4]);
        if (i + 2 < points.size())
            mesh_.prefetchNeighbours(slots[i + 2]);
        if (i + 1 < points.size())
            mesh_.prefetchSurroundings(slots[i + 1]);
        // An earlier one of the step may have destroyed it.
        std::uint32_t slot = slots[i];
        if (!mesh_.conflicts(points[i], slot))
            slot = mesh_.findConflict(points[i], startFor(points[i]));
        if (slot == LatticeDelaunay::none || !mesh_.insert(points[i], slot))
            return false;
        last_ = mesh_.created().front();
        for (Hints& hints : hints_)
            hintOf(hints, points[i]) = last_;
        added(i);
    }
    return true;
}

namespace {

/// The blocks that have the coordinates along an axis.
struct BlocksAlong {
    std::uint32_t first, last;
};

std::array<std::vector<BlocksAlong>, 3> blocksAlongAxes(const BlockDivision& division)
{
    std::array<std::vector<BlocksAlong>, 3> blocks;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t coordinate = 0; coordinate < division.size()[axis]; ++coordinate) {
            const std::uint32_t last = division.blockAlong(axis, coordinate);
            const bool shared = last > 0 && coordinate == division.box(0).last(axis) * last;
            blocks[axis].push_back({shared ? last - 1 : last, last});
        }
    return blocks;
}

/// The sites that enter each block, by their places in `sites`; those on a border enter each block that has them.
std::vector<std::vector<std::uint32_t>> sitesOfBlocks(const BlockDivision& division,
                                                      std::span<const std::uint32_t> sites)
{
    const PackedLattice lattice(division.size());
    const auto along = blocksAlongAxes(division);
    std::vector<std::vector<std::uint32_t>> entering(division.count());
    for (std::uint32_t site = 0; site < sites.size(); ++site) {
        const PackedPoint point = lattice.pointAt(sites[site]);
        const auto x = along[0][static_cast<std::size_t>(lattice.x(point))],
                   y = along[1][static_cast<std::size_t>(lattice.y(point))],
                   z = along[2][static_cast<std::size_t>(lattice.z(point))];
        for (std::uint32_t k = z.first; k <= z.last; ++k)
            for (std::uint32_t j = y.first; j <= y.last; ++j)
                for (std::uint32_t i = x.first; i <= x.last; ++i)
                    entering[(k * division.countAlong(1) + j) * division.countAlong(0) + i].push_back(site);
    }
    return entering;
}

/// The largest first, so that none is left for the end.
std::vector<std::uint32_t> orderOfBlocks(const std::vector<std::vector<std::uint32_t>>& entering)
{
    std::vector<std::uint32_t> order(entering.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](std::uint32_t block) { return entering[block].size(); });
    return order;
}

Error grewTooLarge()
{
    return {ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
}

} // namespace

/// Where a block lies in the lattice, and its mesh.
class PlacedBlock {
public:
    PlacedBlock(const BlockDivision& division, std::uint32_t block, ReplayedBlock& replayed)
        : lattice_(division.size()), box_(division.box(block)), replayed_(replayed)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            own_[axis] = box_.size[axis] - (box_.last(axis) == division.size()[axis] - 1 ? 0 : 1);
    }

    ReplayedBlock& mesh() noexcept { return replayed_; }
    const LatticeBox& box() const noexcept { return box_; }
    /// So many of its points along each axis are its own: those on a border belong to the last block that has them.
    const std::array<std::uint32_t, 3>& own() const noexcept { return own_; }
    bool owns(PackedPoint inBlock) const
    {
        const auto [x, y, z] = placeIn(replayed_.lattice(), inBlock);
        return x < own_[0] && y < own_[1] && z < own_[2];
    }
    PackedPoint inBlock(PackedPoint inLattice) const
    {
        const auto [x, y, z] = placeIn(lattice_, inLattice);
        return replayed_.lattice().pack(x - box_.origin[0], y - box_.origin[1], z - box_.origin[2]);
    }
    PackedPoint inLattice(PackedPoint inBlock) const
    {
        const auto [x, y, z] = placeIn(replayed_.lattice(), inBlock);
        return lattice_.pack(x + box_.origin[0], y + box_.origin[1], z + box_.origin[2]);
    }
    const PackedLattice& wholeLattice() const noexcept { return lattice_; }
    ReplayPlaces::Vertices verticesIn(std::uint32_t slot) const
    {
        ReplayPlaces::Vertices vertices = replayed_.mesh()[slot].vertices;
        for (PackedPoint& vertex : vertices)
            vertex = inLattice(vertex);
        return vertices;
    }

private:
    static std::array<std::uint32_t, 3> placeIn(const PackedLattice& lattice, PackedPoint point)
    {
        return {static_cast<std::uint32_t>(lattice.x(point)), static_cast<std::uint32_t>(lattice.y(point)),
                static_cast<std::uint32_t>(lattice.z(point))};
    }

    PackedLattice lattice_;
    LatticeBox box_;
    std::array<std::uint32_t, 3> own_{};
    ReplayedBlock& replayed_;
};

/// Notes what the sites that enter a block do to its mesh.
class BlockRecorder {
public:
    /// `corners`: of all blocks; `siteCount`: how many enter.
    BlockRecorder(PlacedBlock& block, std::span<const std::uint32_t> corners, std::size_t siteCount,
                  BlockHistory& history);
    /// The site of this place was just added.
    void added(PackedPoint inBlock, std::uint32_t place);

private:
    ReplayedBlock& block_;
    std::uint32_t cornerCount_;
    BlockHistory& history_;
    std::vector<std::uint32_t> numbers_; ///< of the tetrahedra in the mesh's slots
};

BlockRecorder::BlockRecorder(PlacedBlock& block, std::span<const std::uint32_t> corners, std::size_t siteCount,
                             BlockHistory& history)
    : block_(block.mesh()), cornerCount_(static_cast<std::uint32_t>(corners.size())), history_(history),
      numbers_(LatticeDelaunay::startCount)
{
    std::iota(numbers_.begin(), numbers_.end(), 0u);
    constexpr std::size_t usuallyMade = 18, usuallyDestroyed = 12; // by a site
    history_.sites.reserve(siteCount);
    history_.destroyed.reserve(usuallyDestroyed * siteCount);
    history_.otherSites.reserve(usuallyMade * siteCount);
    history_.destroyers.reserve(LatticeDelaunay::startCount + usuallyMade * siteCount);
    history_.destroyers.assign(LatticeDelaunay::startCount, BlockHistory::never);
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const auto [x, y, z] = block.box().corner(corner);
        const PackedPoint point = block.wholeLattice().pack(x, y, z);
        const auto found = std::ranges::lower_bound(corners, block.wholeLattice().index(point));
        block_.label(block.inBlock(point), static_cast<std::uint32_t>(found - corners.begin()));
    }
}

void BlockRecorder::added(PackedPoint inBlock, std::uint32_t place)
{
    const LatticeDelaunay& mesh = block_.mesh();
    for (const std::uint32_t slot : mesh.destroyed()) {
        history_.destroyers[numbers_[slot]] = place;
        history_.destroyed.push_back(numbers_[slot]);
    }
    const std::span<const std::uint32_t> labels = mesh.star().labels();
    const std::span<const std::array<std::uint32_t, 3>> corners = mesh.star().corners();
    for (std::size_t i = 0; i < mesh.created().size(); ++i) {
        const std::uint32_t slot = mesh.created()[i];
        if (slot >= numbers_.size())
            numbers_.resize(slot + 1 + slot / 2);
        numbers_[slot] = static_cast<std::uint32_t>(history_.destroyers.size());
        history_.destroyers.push_back(BlockHistory::never);
        const auto& [a, b, c] = corners[i];
        history_.otherSites.push_back({labels[a], labels[b], labels[c]});
    }
    history_.sites.push_back({place, static_cast<std::uint32_t>(history_.destroyed.size()),
                              static_cast<std::uint32_t>(history_.otherSites.size())});
    block_.label(inBlock, cornerCount_ + place);
}

Status ReplayPlaces::find(const BlockDivision& division, const LatticeMetric& metric,
                          std::span<const std::uint32_t> sites, std::span<const std::uint32_t> stepEnds,
                          const FreePoints& others, BlockHistories* histories, const Progress& progress)
{
    ofSites_.resize(sites.size());
    if (histories != nullptr)
        histories->blocks.resize(division.count());
    if (others.count() > 0)
        numbers_.resize(others.size());
    const auto entering = sitesOfBlocks(division, sites);
    const std::vector<std::uint32_t> order = orderOfBlocks(entering);
    const auto total = std::transform_reduce(entering.begin(), entering.end(), 0.0, std::plus<>(),
                                             [](const auto& some) { return static_cast<double>(some.size()); });
    SharedProgress shared(progress, total, replayingBlocks);
    FirstFailure failure;
    tbb::enumerable_thread_specific<ReplayedBlock> replayed;
    std::atomic<std::uint32_t> next = 0;
    const auto replayNext = [&]() -> Status {
        if (failure.happened())
            return {};
        const std::uint32_t number = order[next++];
        const auto points = static_cast<double>(entering[number].size());
        const Progress own = failure.watching(progress).withCallback(shared.piece(points));
        PlacedBlock block(division, number, replayed.local());
        if (const Status started = block.mesh().start(block.box(), metric, division.odd(number)); !started)
            return started;
        std::optional<BlockRecorder> recorder;
        if (histories != nullptr)
            recorder.emplace(block, histories->corners, entering[number].size(), histories->blocks[number]);
        const Status placed =
            placeSites(block, entering[number], sites, stepEnds, recorder ? &*recorder : nullptr, own);
        if (!placed)
            return placed;
        own.report(1, {});
        return others.count() == 0 ? Status() : placeOthers(block, others, own);
    };
    tbb::parallel_for(std::uint32_t(0), division.count(), [&](std::uint32_t) { failure.run(replayNext); });
    if (progress.cancelled())
        return cancelledError(replayingBlocks);
    return failure.status();
}

Status ReplayPlaces::placeSites(PlacedBlock& block, std::span<const std::uint32_t> enter,
                                std::span<const std::uint32_t> sites, std::span<const std::uint32_t> stepEnds,
                                BlockRecorder* recorder, const Progress& progress)
{
    constexpr std::size_t toldAtOnce = 4096;
    std::vector<PackedPoint> points;
    std::vector<std::uint32_t> slots;
    std::size_t step = 0, told = 0;
    for (std::size_t begin = 0, end = 0; begin < enter.size(); begin = end) {
        if (end - told >= toldAtOnce) {
            if (progress.cancelled())
                return cancelledError(replayingBlocks);
            told = end;
            progress.report(static_cast<double>(told) / static_cast<double>(enter.size()), {});
        }
        while (stepEnds[step] <= enter[begin])
            ++step;
        points.clear();
        for (; end < enter.size() && enter[end] < stepEnds[step]; ++end)
            points.push_back(block.inBlock(block.wholeLattice().pointAt(sites[enter[end]])));
        if (!block.mesh().place(points, slots))
            return grewTooLarge();
        for (std::size_t i = 0; i < points.size(); ++i)
            if (block.owns(points[i]))
                ofSites_[enter[begin + i]] = block.verticesIn(slots[i]);
        const bool added =
            recorder == nullptr
                ? block.mesh().add(points, slots, [](std::size_t) {})
                : block.mesh().add(points, slots, [&](std::size_t i) { recorder->added(points[i], enter[begin + i]); });
        if (!added)
            return grewTooLarge();
    }
    return {};
}

Status ReplayPlaces::placeOthers(PlacedBlock& block, const FreePoints& others, const Progress& progress)
{
    std::vector<std::uint32_t> numbers(block.mesh().mesh().slotCount(), LatticeDelaunay::none);
    std::vector<Vertices> tetrahedra;
    std::vector<PackedPoint> points;
    std::vector<std::uint32_t> slots, placed;
    for (std::uint32_t z = 0; z < block.own()[2]; ++z) {
        const std::size_t before = placed.size();
        points.clear();
        for (std::uint32_t y = 0; y < block.own()[1]; ++y)
            for (std::uint32_t x = 0; x < block.own()[0]; ++x) {
                const PackedPoint inside = block.mesh().lattice().pack(x, y, z);
                const std::uint32_t point = block.wholeLattice().index(block.inLattice(inside));
                if (!others.has(point))
                    continue;
                points.push_back(inside);
                placed.push_back(point);
            }
        if (progress.cancelled())
            return cancelledError(replayingBlocks);
        if (!block.mesh().place(points, slots))
            return grewTooLarge();
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::uint32_t& number = numbers[slots[i]];
            if (number == LatticeDelaunay::none) {
                number = static_cast<std::uint32_t>(tetrahedra.size());
                tetrahedra.push_back(block.verticesIn(slots[i]));
            }
            numbers_[placed[before + i]] = number;
        }
    }
    std::size_t first = 0;
    {
        const std::lock_guard lock(gathering_);
        first = tetrahedra_.size();
        tetrahedra_.insert(tetrahedra_.end(), tetrahedra.begin(), tetrahedra.end());
    }
    for (const std::uint32_t point : placed)
        numbers_[point] += static_cast<std::uint32_t>(first);
    return {};
}

} // namespace tetra
