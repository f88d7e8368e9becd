// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/reserved_array.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/packed_lattice.h"
#include "core/refine/lattice/star.h"

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A live tetrahedron: one cache line. vertices[0] entered last. The sphere is kept relative to vertices[0]: a point at
/// offset q is strictly inside if determinant * |q|^2 < centre . q, where |q|^2 is weighted by the metric.
struct alignas(64) DelaunayTetrahedron {
    std::array<PackedPoint, 4> vertices;     ///< positive: det(v1 - v0, v2 - v0, v3 - v0) > 0
    std::array<std::uint32_t, 4> neighbours; ///< opposite to each vertex; LatticeDelaunay::none on the hull
    std::array<double, 4> sphere;            ///< 2 * determinant * (circumcentre - v0), weighted by the metric; then
                                             ///< the determinant
    /// Six times the volume, a positive integer; 0 marks a dead slot.
    double determinant() const noexcept { return sphere[3]; }
};

/// What became of a mesh that was to be taken over.
enum class MeshLoading {
    Done,
    NoMesh,      ///< not positive, not conforming, no cover, or with a tetrahedron that reaches into two boxes
    NotDelaunay, ///< a mesh, but one with a vertex strictly inside a circumsphere
    Cancelled,
};

/// Incremental Delaunay tetrahedrization of a box of lattice points, with exact arithmetic (S8; 3.1, ADD_VERTEX).
/// Starts with the eight corners cut into five. A tetrahedron conflicts with a new point only if the point lies
/// *strictly* inside its circumsphere: the newest point loses every cospherical tie, which is a valid symbolic
/// perturbation, needs no code for ties and never makes a flat tetrahedron (S7). There is no vertex at infinity: hull
/// faces have no neighbour. One thread. An insertion costs O(cavity), 12 tetrahedra destroyed and 17 made on average.
class LatticeDelaunay {
public:
    /// The slots of the five tetrahedra of the start.
    static constexpr std::uint32_t startCount = 5;
    /// The slot of no tetrahedron.
    static constexpr std::uint32_t none = 0xffffffff;

    /// May be called again for another box, in the same memory. Errors: the lattice is too large for exact arithmetic,
    /// or memory is refused. `centreAtOrigin` says whether the start's fifth tetrahedron, the one without a corner of
    /// its own, has the box's first corner.
    Status start(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric, bool centreAtOrigin = true);

    const PackedLattice& lattice() const noexcept { return lattice_; }
    /// In place of start(), for several boxes of one lattice side by side, each with a tetrahedrization of its own:
    /// prepare() once, then addBox() for each before the first insertion. Errors: as of start().
    Status prepare(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric, std::uint64_t slots);
    /// The corners of `box` cut into five; the first of their slots.
    std::uint32_t addBox(const LatticeBox& box, bool centreAtOrigin);

    /// After prepare(), in place of addBox(): takes over a Delaunay mesh of each box of a division, tetrahedron i into
    /// slot i, and finds their neighbours. Of no use afterwards unless that is Done. About 5 million tetrahedra a
    /// second. May throw std::bad_alloc.
    [[nodiscard]] MeshLoading load(std::span<const std::array<PackedPoint, 4>> tetrahedra,
                                   const BlockDivision& division, const Progress& progress);
    /// Goes back to a mesh that was: `tetrahedra` are all its slots, none dead; `changed` are those of its slots that
    /// were overwritten since.
    void restore(std::span<const DelaunayTetrahedron> tetrahedra, std::span<const std::uint32_t> changed);
    std::span<const DelaunayTetrahedron> tetrahedra() const noexcept { return {tetrahedra_.data() + 1, slotCount_}; }

    /// Slots in use or once used: every valid slot is smaller.
    std::uint32_t slotCount() const noexcept { return slotCount_; }
    const DelaunayTetrahedron& operator[](std::uint32_t slot) const noexcept { return at(slot); }

    /// Inserts a lattice point that is not a vertex yet; `containing` is a live tetrahedron that contains it, or
    /// one that findConflict() gave. star()
    /// and destroyed() then tell what changed. False if the slots are exhausted (the mesh is then unusable).
    [[nodiscard]] bool insert(PackedPoint point, std::uint32_t containing);

    /// A tetrahedron whose circumsphere has a lattice point that is not a vertex yet strictly inside, so that insert()
    /// may start from it: found by going from the live one `from`, in the same box, always nearer to the point.
    /// `none` if that leads nowhere, which no Delaunay mesh does to a point of its box.
    std::uint32_t findConflict(PackedPoint point, std::uint32_t from) const;

    /// Whether a slot has a tetrahedron whose circumsphere has the point strictly inside.
    bool conflicts(PackedPoint point, std::uint32_t slot) const noexcept
    {
        const DelaunayTetrahedron& tetrahedron = at(slot);
        const PackedPoint apex = tetrahedron.vertices[0];
        const double x = lattice_.x(point) - lattice_.x(apex), y = lattice_.y(point) - lattice_.y(apex),
                     z = lattice_.z(point) - lattice_.z(apex);
        const std::array<double, 4>& sphere = tetrahedron.sphere;
        return sphere[3] != 0 && sphere[3] * (weights_[0] * x * x + weights_[1] * y * y + weights_[2] * z * z) <
                                     sphere[0] * x + sphere[1] * y + sphere[2] * z;
    }

    /// Gives a vertex a number that star().labels() tells.
    void label(PackedPoint point, std::uint32_t number) { star_.label(point, number); }

    /// Fetch a tetrahedron that is likely to be inserted into soon into the cache, then its neighbours, then theirs and
    /// what is kept for their vertices; each needs the one before: at millions of sites waiting for memory is most of
    /// an insertion (fetchAhead()).
    void prefetch(std::uint32_t slot) const { __builtin_prefetch(&at(slot)); }
    void prefetchNeighbours(std::uint32_t slot) const
    {
        for (const std::uint32_t neighbour : at(slot).neighbours)
            __builtin_prefetch(&at(neighbour));
    }
    void prefetchSurroundings(std::uint32_t slot) const;

    /// The geometry of the tetrahedra made by the last insertion, and their slots (same order).
    const Star& star() const noexcept { return star_; }
    std::span<const std::uint32_t> created() const noexcept { return created_; }
    /// Slots of the tetrahedra that the last insertion destroyed; some are in created() again.
    std::span<const std::uint32_t> destroyed() const noexcept { return destroyed_; }
    /// The mesh, after start() or addBox() of the same box.
    void archive(StateArchive& archive)
    {
        archive(slotCount_, freeSlots_, star_);
        archive.elements(std::span(tetrahedra_.data(), std::size_t(slotCount_) + 1));
    }

    /// The most slots there can ever be.
    std::uint64_t capacity() const noexcept { return slotCapacity_; }

private:
    struct CavityFace {
        std::uint32_t inside;  ///< destroyed tetrahedron
        std::uint32_t outside; ///< its neighbour that stays, or none
        std::uint32_t insideFace;
        std::uint32_t outsideFace;
    };

    /// Before the first slot is a dead tetrahedron, which `none` stands for: a missing neighbour needs no special case.
    DelaunayTetrahedron* records() noexcept { return tetrahedra_.data() + 1; }
    const DelaunayTetrahedron& at(std::uint32_t slot) const noexcept
    {
        return (tetrahedra_.data() + 1)[static_cast<std::int32_t>(slot)];
    }

    MeshLoading loadTetrahedra(std::span<const std::array<PackedPoint, 4>> tetrahedra, const BlockDivision& division,
                               const Progress& progress);
    MeshLoading checkDelaunay(const Progress& progress) const;
    std::uint32_t faceTowards(PackedPoint point, std::uint32_t slot) const;
    bool onHullPlane(PackedPoint point, const DelaunayTetrahedron& tetrahedron, std::uint32_t face) const;
    bool takeSlots();
    // Called by dispatch().
    inline std::uint32_t approach(PackedPoint point, std::uint32_t from) const;
    inline void findCavity(PackedPoint point, std::uint32_t containing);
    inline void gatherStar(PackedPoint point);
    inline void writeStar(PackedPoint point);

    PackedLattice lattice_{{2, 2, 2}};
    std::array<double, 3> weights_{1, 1, 1};
    ReservedArray<DelaunayTetrahedron> tetrahedra_;
    std::uint64_t slotCapacity_ = 0;
    std::uint32_t slotCount_ = 0;
    std::vector<std::uint32_t> freeSlots_;
    Buffer<CavityFace> cavityFaces_;
    Buffer<std::array<PackedPoint, 3>> starFaces_;
    Buffer<std::uint32_t> destroyed_;
    std::vector<std::uint32_t> created_;
    Star star_;
};

/// Of insertions one after the other: fetches what those after number `next` of `count` need, step by step. slotOf(i)
/// is where insertion i will probably begin, or none.
template <class SlotOf>
void fetchAhead(const LatticeDelaunay& delaunay, std::size_t next, std::size_t count, const SlotOf& slotOf)
{
    const auto fetch = [&](std::size_t steps, const auto& what) {
        if (next + steps < count)
            if (const std::uint32_t slot = slotOf(next + steps); slot != LatticeDelaunay::none)
                what(slot);
    };
    fetch(4, [&](std::uint32_t slot) { delaunay.prefetch(slot); });
    fetch(2, [&](std::uint32_t slot) { delaunay.prefetchNeighbours(slot); });
    fetch(1, [&](std::uint32_t slot) { delaunay.prefetchSurroundings(slot); });
}

/// The points of a box but its corners, each with one of the five tetrahedra of the box's start that it lies in, which
/// are those from `firstSlot` on.
std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount>
pointsOfStart(const LatticeDelaunay& delaunay, const LatticeBox& box, std::uint32_t firstSlot);

/// Whether `point` lies on the inner side of the face opposite to `vertices[0]`, or on it.
bool onInnerSide(const PackedLattice& lattice, PackedPoint point, const std::array<PackedPoint, 4>& vertices);

} // namespace tetra
