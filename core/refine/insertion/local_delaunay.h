// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/reserved_array.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/packed_lattice.h"
#include "core/refine/lattice/point_location.h"

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The points of a divided lattice in small cells, none of which reaches into two blocks: a number is kept for each,
/// that of a tetrahedron thereabouts. A point on the border of blocks belongs to a cell of each.
class HintGrid {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    HintGrid() = default;
    /// A cell has `edge` lattice cells along each axis, or fewer. All hints are none.
    HintGrid(const BlockDivision& division, std::uint32_t edge);

    std::uint32_t cellCount() const noexcept { return static_cast<std::uint32_t>(hints_.size()); }
    /// One of the cells that have the point.
    std::uint32_t cellOf(std::uint32_t x, std::uint32_t y, std::uint32_t z) const noexcept
    {
        return axes_[0].cells[x] + axes_[1].cells[y] + axes_[2].cells[z];
    }
    /// One cell for each block that has the point, eight at most, in rising order of the blocks; how many.
    std::uint32_t cellsOf(const std::array<std::uint32_t, 3>& point,
                          std::array<std::uint32_t, 8>& cells) const noexcept;
    /// The first and the last point along an axis of the block that a cell lies in.
    struct Bounds {
        std::int32_t first = 0;
        std::int32_t last = 0;
    };
    std::array<Bounds, 3> blockOf(std::uint32_t cell) const noexcept;
    bool dividesBlocks() const noexcept { return dividesBlocks_; }

    std::uint32_t& operator[](std::uint32_t cell) noexcept { return hints_[cell]; }
    std::uint32_t operator[](std::uint32_t cell) const noexcept { return hints_[cell]; }
    void prefetch(std::uint32_t cell) const { __builtin_prefetch(&hints_[cell]); }

    /// Gives each cell without a hint that of a cell near it in its block, if there is any in the block.
    void spread();

private:
    struct Axis {
        std::vector<std::uint32_t> cells;      ///< of each point, times the stride
        std::vector<std::uint32_t> cellsBelow; ///< likewise in the block before, on a border; else the same
        std::vector<Bounds> blocks;            ///< of each cell
        std::uint32_t stride = 1;
    };

    std::array<Axis, 3> axes_;
    bool dividesBlocks_ = false;
    Buffer<std::uint32_t> hints_;
};

/// Points of a lattice, as bits: each row along x in words of its own.
class PointSet {
public:
    /// Empty. Memory comes where there are points. Error: refused address space.
    Status start(const std::array<std::uint32_t, 3>& size)
    {
        rowWords_ = (size[0] + 63) / 64;
        rows_ = size[1];
        return words_.reserve(std::uint64_t(rowWords_) * size[1] * size[2],
                              Message::marked("the set of the mesh's points"));
    }
    std::uint64_t& word(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept { return row(y, z)[x / 64]; }
    bool has(std::uint32_t x, std::uint32_t y, std::uint32_t z) const noexcept
    {
        return (row(y, z)[x / 64] >> x % 64 & 1) != 0;
    }
    void add(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept { word(x, y, z) |= 1ull << x % 64; }
    void remove(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept { word(x, y, z) &= ~(1ull << x % 64); }
    /// The words of a row: the bit x % 64 of word x / 64 is point x.
    const std::uint64_t* row(std::uint32_t y, std::uint32_t z) const noexcept
    {
        return words_.data() + (std::uint64_t(z) * rows_ + y) * rowWords_;
    }
    std::uint64_t* row(std::uint32_t y, std::uint32_t z) noexcept
    {
        return words_.data() + (std::uint64_t(z) * rows_ + y) * rowWords_;
    }

private:
    std::uint32_t rowWords_ = 1;
    std::uint32_t rows_ = 1;
    ReservedArray<std::uint64_t> words_;
};

/// A Delaunay mesh of a lattice, whole or in blocks that conform, to which points are added here and there, and which
/// then goes back to what it was, at the cost of what changed. Vertices are numbered, those of the first mesh first. A
/// point on the border of blocks is added to each. One thread. Allocations throw std::bad_alloc.
class LocalDelaunay {
public:
    LocalDelaunay();
    LocalDelaunay(const LocalDelaunay&) = delete;
    LocalDelaunay& operator=(const LocalDelaunay&) = delete;

    /// Comes first. Errors: too large a lattice, refused address space.
    Status prepare(const BlockDivision& division, const LatticeMetric& metric);
    /// Takes over a Delaunay mesh of each block's box, tetrahedra by numbers of `vertices`. Unless that is Done, it
    /// must be loaded again before anything else.
    [[nodiscard]] MeshLoading load(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                   std::span<const PackedPoint> vertices, const Progress& progress = {});
    /// Back to what was loaded.
    void restore();

    const LatticeDelaunay& mesh() const noexcept { return mesh_; }
    const PackedLattice& lattice() const noexcept { return mesh_.lattice(); }
    const PointSet& vertices() const noexcept { return vertexSet_; }
    bool isVertex(PackedPoint point) const noexcept
    {
        const auto [x, y, z] = coordinates(point);
        return vertexSet_.has(x, y, z);
    }
    /// The points added since load() or restore(), in order; their numbers follow those of the first mesh.
    std::span<const PackedPoint> added() const noexcept { return added_; }

    /// Adds points that are not vertices yet, one after the other. False if the mesh cannot take them: it is too large,
    /// or not what load() had seen.
    [[nodiscard]] bool add(std::span<const PackedPoint> points) { return add(points, {}); }
    /// `slots`: of each point one that place() gave a short while ago, or none. That is faster. Which slots and orders
    /// tetrahedra get depends on them.
    [[nodiscard]] bool add(std::span<const PackedPoint> points, std::span<const std::uint32_t> slots);
    /// Where points of the lattice lie, on a border of blocks in one of these: as many as `placed` has room for.
    /// Quicker for points that are near those before them. From any thread, while nothing changes. No slot where the
    /// mesh is not what load() had seen.
    void place(std::span<const PackedPoint> points, std::span<PlacedPoint> placed) const;

    /// The slots made or emptied since the last acceptChanges() (or load, restore), each once.
    std::span<const std::uint32_t> changed() const noexcept { return {changed_.data(), changedCount_}; }
    bool hasChanged(std::uint32_t slot) const noexcept { return (flags_[slot] & changedNow) != 0; }
    /// Whether a slot still has its tetrahedron of the first mesh, or a later one has not changed since accepted.
    bool isFirst(std::uint32_t slot) const noexcept { return slot < firstTetrahedra_.size() && flags_[slot] == 0; }
    void acceptChanges();
    /// All that were accepted since load() or restore(), each once.
    std::span<const std::uint32_t> changedEarlier() const noexcept { return changedEarlier_; }

    /// The numbers of a tetrahedron's vertices, positive.
    const std::array<std::uint32_t, 4>& numbers(std::uint32_t slot) const noexcept { return numbers_[slot]; }
    void prefetchNumbers(std::uint32_t slot) const { __builtin_prefetch(&numbers_[slot]); }
    /// Whether a slot has a tetrahedron.
    bool isAlive(std::uint32_t slot) const noexcept { return numbers_[slot][0] != noVertex; }
    /// All tetrahedra, by numbers of vertices; in the order of their slots.
    void copyTetrahedra(Buffer<std::array<std::uint32_t, 4>>& tetrahedra) const;

private:
    static constexpr std::uint32_t noVertex = 0xffffffff; ///< of a slot that holds no tetrahedron
    static constexpr std::uint8_t changedNow = 1;
    static constexpr std::uint8_t changedBefore = 2;

    std::array<std::uint32_t, 3> coordinates(PackedPoint point) const noexcept
    {
        const PackedLattice& lattice = mesh_.lattice();
        return {static_cast<std::uint32_t>(lattice.x(point)), static_cast<std::uint32_t>(lattice.y(point)),
                static_cast<std::uint32_t>(lattice.z(point))};
    }
    std::uint32_t cellOf(PackedPoint point) const noexcept
    {
        const auto [x, y, z] = coordinates(point);
        return hints_.cellOf(x, y, z);
    }
    void fetchAhead(std::span<const PackedPoint> points, std::span<const std::uint32_t> slots, std::size_t next) const;
    bool addOne(PackedPoint point, std::uint32_t slot);
    bool insertAt(PackedPoint point, std::uint32_t slot, std::uint32_t cell, std::uint32_t number);
    std::uint32_t startFor(std::uint32_t cell) const;
    std::int32_t distance(PackedPoint point, std::uint32_t slot) const;
    std::uint32_t blockOf(const std::array<HintGrid::Bounds, 3>& bounds) const;
    bool lies(std::uint32_t slot, const std::array<HintGrid::Bounds, 3>& block) const;
    void note(std::uint32_t slot);
    void dropMesh();

    BlockDivision division_{{2, 2, 2}, 0};
    LatticeDelaunay mesh_;
    HintGrid hints_;
    std::vector<std::uint32_t> lastOfBlocks_; ///< of each block a tetrahedron, the last that was made there
    PointSet vertexSet_;
    ReservedArray<std::array<std::uint32_t, 4>> numbers_;
    ReservedArray<std::uint8_t> flags_;
    Buffer<std::uint32_t> changed_;
    std::size_t changedCount_ = 0;
    std::vector<std::uint32_t> changedEarlier_; ///< accepted
    std::vector<PackedPoint> added_;

    Buffer<DelaunayTetrahedron> firstTetrahedra_;
    Buffer<std::array<std::uint32_t, 4>> firstNumbers_;
    HintGrid firstHints_;
    std::vector<PackedPoint> firstVertices_;
};

} // namespace tetra
