// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/hint_grid.h"
#include "core/mesh/lattice_delaunay.h"
#include "core/mesh/point_set.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

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
    [[nodiscard]] bool add(std::span<const PackedPoint> points);

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
    void fetchAhead(std::span<const PackedPoint> points, std::size_t next) const;
    bool addOne(PackedPoint point);
    bool insertAt(PackedPoint point, std::uint32_t cell, std::uint32_t number);
    std::uint32_t startFor(std::uint32_t cell) const;
    bool lies(std::uint32_t slot, const std::array<HintGrid::Bounds, 3>& block) const;
    void note(std::uint32_t slot);
    void dropMesh();

    BlockDivision division_{{2, 2, 2}, 0};
    LatticeDelaunay mesh_;
    HintGrid hints_;
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
