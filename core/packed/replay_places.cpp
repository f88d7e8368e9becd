// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay_places.h"

#include "core/base/progress.h"
#include "core/refine/insertion/local_delaunay.h"
#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/point_location.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <optional>

namespace tetra {

namespace {

constexpr MarkedText replayingBlocks = Message::marked("Replaying the insertions");

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
    std::uint32_t& hintOf(HintGrid& hints, PackedPoint point) const
    {
        const PackedLattice& lattice = mesh_.lattice();
        return hints[hints.cellOf(static_cast<std::uint32_t>(lattice.x(point)),
                                  static_cast<std::uint32_t>(lattice.y(point)),
                                  static_cast<std::uint32_t>(lattice.z(point)))];
    }
    std::uint32_t startFor(PackedPoint point)
    {
        for (HintGrid& hints : hints_)
            if (const std::uint32_t hint = hintOf(hints, point);
                hint != LatticeDelaunay::none && mesh_[hint].determinant() != 0)
                return hint;
        return last_;
    }

    LatticeDelaunay mesh_;
    /// Of tetrahedra, the last that was made in each cell; where none was, a larger cell tells.
    std::array<HintGrid, 3> hints_;
    std::uint32_t last_ = 0; ///< that was made
};

Status ReplayedBlock::start(const LatticeBox& box, const LatticeMetric& metric, bool odd)
{
    if (const Status started = mesh_.start(box.size, metric, !odd); !started)
        return started;
    constexpr std::array<std::uint32_t, 3> edges = {2, 8, 32};
    const BlockDivision oneBlock(box.size, 0);
    for (std::size_t i = 0; i < edges.size(); ++i)
        hints_[i] = HintGrid(oneBlock, edges[i]);
    last_ = LatticeDelaunay::startCount - 1;
    return {};
}

bool ReplayedBlock::place(std::span<const PackedPoint> points, std::vector<std::uint32_t>& slots)
{
    slots.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        slots[i] = startFor(points[i]);
    locate(mesh_, points, slots);
    return std::ranges::find(slots, LatticeDelaunay::none) == slots.end();
}

template <class Added>
bool ReplayedBlock::add(std::span<const PackedPoint> points, std::span<const std::uint32_t> slots, const Added& added)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        fetchAhead(mesh_, i, points.size(), [&](std::size_t next) { return slots[next]; });
        // An earlier one of the step may have destroyed it.
        std::uint32_t slot = slots[i];
        if (!mesh_.conflicts(points[i], slot))
            slot = mesh_.findConflict(points[i], startFor(points[i]));
        if (slot == LatticeDelaunay::none || !mesh_.insert(points[i], slot))
            return false;
        last_ = mesh_.created().front();
        for (HintGrid& hints : hints_)
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
