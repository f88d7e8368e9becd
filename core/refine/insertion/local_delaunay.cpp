// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/insertion/local_delaunay.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace tetra {

HintGrid::HintGrid(const BlockDivision& division, std::uint32_t edge) : dividesBlocks_(division.count() > 1)
{
    std::uint32_t stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Axis& along = axes_[axis];
        along.stride = stride;
        const std::uint32_t points = division.size()[axis];
        std::uint32_t first = 0;
        for (std::uint32_t point = 0; point < points; ++point) {
            const bool last = point == points - 1;
            const bool border = division.isBorder(axis, point);
            const std::uint32_t cellBefore =
                along.blocks.empty() ? 0 : static_cast<std::uint32_t>(along.blocks.size() - 1);
            if (border && point > 0)
                for (std::size_t cell = along.blocks.size(); cell-- > 0 && along.blocks[cell].last < 0;)
                    along.blocks[cell].last = static_cast<std::int32_t>(point);
            if (border)
                first = last ? first : point;
            if (!last && (point - first) % edge == 0)
                along.blocks.push_back({static_cast<std::int32_t>(first), -1});
            along.cells.push_back(static_cast<std::uint32_t>(along.blocks.size() - 1) * stride);
            along.cellsBelow.push_back(border && !last ? cellBefore * stride : along.cells.back());
        }
        stride *= static_cast<std::uint32_t>(along.blocks.size());
    }
    hints_.assign(stride, none);
}

std::uint32_t HintGrid::cellsOf(const std::array<std::uint32_t, 3>& point,
                                std::array<std::uint32_t, 8>& cells) const noexcept
{
    cells[0] = 0;
    std::uint32_t count = 1;
    for (std::size_t axis = 3; axis-- > 0;) {
        const std::uint32_t above = axes_[axis].cells[point[axis]];
        const std::uint32_t below = axes_[axis].cellsBelow[point[axis]];
        const std::uint32_t before = count;
        if (above != below) {
            // Before each other cell the one of the block below, so that they rise.
            for (std::uint32_t i = before; i-- > 0;) {
                cells[2 * i + 1] = cells[i] + above;
                cells[2 * i] = cells[i] + below;
            }
            count *= 2;
        } else {
            for (std::uint32_t i = 0; i < before; ++i)
                cells[i] += above;
        }
    }
    return count;
}

std::array<HintGrid::Bounds, 3> HintGrid::blockOf(std::uint32_t cell) const noexcept
{
    std::array<Bounds, 3> bounds;
    for (std::size_t axis = 3; axis-- > 0;) {
        bounds[axis] = axes_[axis].blocks[cell / axes_[axis].stride];
        cell %= axes_[axis].stride;
    }
    return bounds;
}

void HintGrid::spread()
{
    const auto copyWithin = [this](std::size_t axis, std::uint32_t from, std::uint32_t to) {
        const Axis& along = axes_[axis];
        const auto count = static_cast<std::uint32_t>(along.blocks.size());
        if (hints_[to] == none &&
            along.blocks[from / along.stride % count].first == along.blocks[to / along.stride % count].first)
            hints_[to] = hints_[from];
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t stride = axes_[axis].stride;
        const auto count = static_cast<std::uint32_t>(axes_[axis].blocks.size());
        for (std::uint32_t cell = 0; cell < cellCount(); ++cell)
            if (cell / stride % count > 0)
                copyWithin(axis, cell - stride, cell);
        for (std::uint32_t cell = cellCount(); cell-- > 0;)
            if (cell / stride % count + 1 < count)
                copyWithin(axis, cell + stride, cell);
    }
}

namespace {

/// Cells of the hints: the smaller, the shorter the way, but they should stay in the cache.
constexpr std::uint32_t hintEdge = 4;

} // namespace

LocalDelaunay::LocalDelaunay() = default;

Status LocalDelaunay::prepare(const BlockDivision& division, const LatticeMetric& metric)
{
    const auto& size = division.size();
    // Six to seven tetrahedra a point, with room to spare; borders of blocks have their points more than once.
    const std::uint64_t points = std::uint64_t(size[0]) * size[1] * size[2];
    const std::uint64_t slots = 10 * points + 100 * std::uint64_t(division.count()) + 4096;
    if (const Status prepared = mesh_.prepare(size, metric, slots); !prepared)
        return prepared;
    division_ = division;
    hints_ = HintGrid(division, hintEdge);
    lastOfBlocks_.assign(division.count(), HintGrid::none);
    if (const Status started = vertexSet_.start(size); !started)
        return started;
    if (const Status reserved =
            numbers_.reserve(mesh_.capacity(), Message::marked("the vertices of the mesh's tetrahedra"));
        !reserved)
        return reserved;
    return flags_.reserve(mesh_.capacity(), Message::marked("the state of the mesh's tetrahedra"));
}

void LocalDelaunay::dropMesh()
{
    if (!firstTetrahedra_.empty())
        restore();
    for (const PackedPoint point : firstVertices_) {
        const auto [x, y, z] = coordinates(point);
        vertexSet_.remove(x, y, z);
    }
    firstVertices_.clear();
    firstTetrahedra_.clear();
}

MeshLoading LocalDelaunay::load(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                std::span<const PackedPoint> vertices, const Progress& progress)
{
    dropMesh();
    Buffer<std::array<PackedPoint, 4>> corners(tetrahedra.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k)
            corners[i][k] = vertices[tetrahedra[i][k]];
    if (const MeshLoading loaded = mesh_.load(corners, division_, progress); loaded != MeshLoading::Done)
        return loaded;
    firstTetrahedra_.assign(mesh_.tetrahedra().begin(), mesh_.tetrahedra().end());
    firstNumbers_.assign(tetrahedra.begin(), tetrahedra.end());
    std::memcpy(static_cast<void*>(numbers_.data()), tetrahedra.data(), tetrahedra.size_bytes());
    firstVertices_.assign(vertices.begin(), vertices.end());
    for (std::uint32_t number = 0; number < vertices.size(); ++number) {
        const auto [x, y, z] = coordinates(vertices[number]);
        vertexSet_.add(x, y, z);
        mesh_.label(vertices[number], number);
    }
    for (std::uint32_t cell = 0; cell < hints_.cellCount(); ++cell)
        hints_[cell] = HintGrid::none;
    for (std::uint32_t slot = 0; slot < corners.size(); ++slot) {
        // Its middle, rounded down: never in the last planes of the block, which belong to the next one.
        std::array<std::uint32_t, 3> middle{};
        for (const PackedPoint corner : corners[slot]) {
            const auto place = coordinates(corner);
            for (std::size_t axis = 0; axis < 3; ++axis)
                middle[axis] += place[axis];
        }
        hints_[hints_.cellOf(middle[0] / 4, middle[1] / 4, middle[2] / 4)] = slot;
    }
    hints_.spread();
    firstHints_ = hints_;
    return MeshLoading::Done;
}

void LocalDelaunay::restore()
{
    acceptChanges();
    std::erase_if(changedEarlier_, [this](std::uint32_t slot) {
        flags_[slot] = 0;
        return slot >= firstTetrahedra_.size();
    });
    for (const std::uint32_t slot : changedEarlier_)
        numbers_[slot] = firstNumbers_[slot];
    mesh_.restore(firstTetrahedra_, changedEarlier_);
    changedEarlier_.clear();
    std::array<std::uint32_t, 8> cells{};
    for (const PackedPoint point : added_) {
        const auto place = coordinates(point);
        vertexSet_.remove(place[0], place[1], place[2]);
        const std::uint32_t count = hints_.cellsOf(place, cells);
        for (std::uint32_t i = 0; i < count; ++i)
            hints_[cells[i]] = firstHints_[cells[i]];
    }
    added_.clear();
    std::ranges::fill(lastOfBlocks_, HintGrid::none);
}

void LocalDelaunay::acceptChanges()
{
    for (const std::uint32_t slot : changed()) {
        if ((flags_[slot] & changedBefore) == 0)
            changedEarlier_.push_back(slot);
        flags_[slot] = changedBefore;
    }
    changedCount_ = 0;
}

void LocalDelaunay::fetchAhead(std::span<const PackedPoint> points, std::span<const std::uint32_t> slots,
                               std::size_t next) const
{
    if (slots.empty() && next + 6 < points.size())
        hints_.prefetch(cellOf(points[next + 6]));
    tetra::fetchAhead(mesh_, next, points.size(),
                      [&](std::size_t i) { return slots.empty() ? hints_[cellOf(points[i])] : slots[i]; });
}

bool LocalDelaunay::add(std::span<const PackedPoint> points, std::span<const std::uint32_t> slots)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        fetchAhead(points, slots, i);
        if (!addOne(points[i], slots.empty() ? HintGrid::none : slots[i]))
            return false;
    }
    return true;
}

bool LocalDelaunay::addOne(PackedPoint point, std::uint32_t slot)
{
    const auto number = static_cast<std::uint32_t>(firstVertices_.size() + added_.size());
    const auto place = coordinates(point);
    added_.push_back(point);
    vertexSet_.add(place[0], place[1], place[2]);
    if (!hints_.dividesBlocks())
        return insertAt(point, slot, hints_.cellOf(place[0], place[1], place[2]), number);
    std::array<std::uint32_t, 8> cells{};
    const std::uint32_t count = hints_.cellsOf(place, cells);
    for (std::uint32_t i = 0; i < count; ++i)
        if (!insertAt(point, slot, cells[i], number))
            return false;
    return true;
}

bool LocalDelaunay::insertAt(PackedPoint point, std::uint32_t slot, std::uint32_t cell, std::uint32_t number)
{
    std::uint32_t found = slot;
    if (slot == HintGrid::none || !mesh_.conflicts(point, slot) ||
        (hints_.dividesBlocks() && !lies(slot, hints_.blockOf(cell)))) {
        const std::uint32_t start = startFor(cell);
        found = start == HintGrid::none ? start : mesh_.findConflict(point, start);
    }
    if (found == LatticeDelaunay::none || !mesh_.insert(point, found))
        return false;
    const std::span<const std::uint32_t> created = mesh_.created();
    const std::span<const std::uint32_t> destroyed = mesh_.destroyed();
    if (changed_.size() < changedCount_ + created.size() + destroyed.size())
        changed_.resize(2 * (changedCount_ + created.size() + destroyed.size()));
    const std::span<const std::uint32_t> labels = mesh_.star().labels();
    const std::array<std::uint32_t, 3>* const corners = mesh_.star().corners().data();
    for (std::size_t i = 0; i < created.size(); ++i) {
        const auto& [a, b, c] = corners[i];
        numbers_[created[i]] = {number, labels[a], labels[b], labels[c]};
        note(created[i]);
    }
    // The slots of the destroyed are taken first.
    for (std::size_t i = created.size(); i < destroyed.size(); ++i) {
        numbers_[destroyed[i]][0] = noVertex;
        note(destroyed[i]);
    }
    mesh_.label(point, number);
    hints_[cell] = created[0];
    if (hints_.dividesBlocks())
        lastOfBlocks_[blockOf(hints_.blockOf(cell))] = created[0];
    return true;
}

/// Of a point from a corner of a tetrahedron, about.
inline std::int32_t LocalDelaunay::distance(PackedPoint point, std::uint32_t slot) const
{
    const PackedLattice& lattice = mesh_.lattice();
    const PackedPoint corner = mesh_[slot].vertices[0];
    return std::abs(lattice.x(corner) - lattice.x(point)) + std::abs(lattice.y(corner) - lattice.y(point)) +
           std::abs(lattice.z(corner) - lattice.z(point));
}

void LocalDelaunay::place(std::span<const PackedPoint> points, std::span<PlacedPoint> placed) const
{
    std::uint32_t before = HintGrid::none;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        fetchAhead(points, {}, i);
        const std::uint32_t cell = cellOf(points[i]);
        std::uint32_t start = startFor(cell);
        if (before != HintGrid::none && start != HintGrid::none &&
            distance(points[i], before) < distance(points[i], start) &&
            (!hints_.dividesBlocks() || lies(before, hints_.blockOf(cell))))
            start = before;
        placed[i] = start == HintGrid::none ? PlacedPoint() : placeIn(mesh_, points[i], start);
        before = placed[i].slot;
    }
}

std::uint32_t LocalDelaunay::blockOf(const std::array<HintGrid::Bounds, 3>& bounds) const
{
    std::uint32_t block = 0;
    for (std::size_t axis = 3; axis-- > 0;)
        block = block * division_.countAlong(axis) +
                division_.blockAlong(axis, static_cast<std::uint32_t>(bounds[axis].first));
    return block;
}

/// Without a branch on whether it is there already, which nobody could predict.
inline void LocalDelaunay::note(std::uint32_t slot)
{
    std::uint8_t& flags = flags_[slot];
    changed_[changedCount_] = slot;
    changedCount_ += (flags & changedNow) == 0;
    flags |= changedNow;
}

/// A live tetrahedron of the cell's block, near the cell if all is as usual.
std::uint32_t LocalDelaunay::startFor(std::uint32_t cell) const
{
    const auto isAlive = [this](std::uint32_t slot) {
        return slot < mesh_.slotCount() && mesh_[slot].determinant() != 0;
    };
    const std::uint32_t hint = hints_[cell];
    if (!hints_.dividesBlocks()) {
        if (isAlive(hint))
            return hint;
    } else if (isAlive(hint) && lies(hint, hints_.blockOf(cell))) {
        return hint;
    }
    // Rare: its slot was given to another tetrahedron, far away, or to none.
    const std::array<HintGrid::Bounds, 3> block = hints_.blockOf(cell);
    if (const std::uint32_t last = lastOfBlocks_[blockOf(block)]; isAlive(last) && lies(last, block))
        return last;
    for (std::uint32_t slot = 0; slot < mesh_.slotCount(); ++slot)
        if (isAlive(slot) && lies(slot, block))
            return slot;
    return HintGrid::none;
}

bool LocalDelaunay::lies(std::uint32_t slot, const std::array<HintGrid::Bounds, 3>& block) const
{
    const PackedLattice& lattice = mesh_.lattice();
    bool inside = true;
    for (const PackedPoint vertex : mesh_[slot].vertices) {
        const std::array<std::int32_t, 3> place = {lattice.x(vertex), lattice.y(vertex), lattice.z(vertex)};
        for (std::size_t axis = 0; axis < 3; ++axis)
            inside &= place[axis] >= block[axis].first && place[axis] <= block[axis].last;
    }
    return inside;
}

void LocalDelaunay::copyTetrahedra(Buffer<std::array<std::uint32_t, 4>>& tetrahedra) const
{
    const std::uint32_t slots = mesh_.slotCount();
    tetrahedra.resize(slots);
    const std::array<std::uint32_t, 4>* const numbers = numbers_.data();
    std::array<std::uint32_t, 4>* to = tetrahedra.data();
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
        *to = numbers[slot];
        to += numbers[slot][0] != noVertex;
    }
    tetrahedra.resize(static_cast<std::size_t>(to - tetrahedra.data()));
}

} // namespace tetra
