// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Tetrahedra with adjacency that half-edge collapses keep conforming. Each has a slot; what survives a collapse stays
/// in its slot, with another vertex.
class CollapsibleMesh {
public:
    static constexpr std::uint32_t none = 0xffffffff;
    /// Numbers of boundary triangles begin here, numbers of slots end before.
    static constexpr std::uint32_t firstTriangle = 0x80000000;
    static constexpr bool isTriangle(std::uint32_t neighbour) noexcept { return neighbour >= firstTriangle; }

    struct Tetrahedron {
        std::array<std::uint32_t, 4> vertices{};   ///< positive; the first is none where the slot is empty
        std::array<std::uint32_t, 4> neighbours{}; ///< slots or boundary triangles, each opposite to the vertex
    };

    /// `tetrahedra` conform, fewer than 2^30. May throw std::bad_alloc.
    CollapsibleMesh(std::uint32_t vertexCount, std::span<const std::array<std::uint32_t, 4>> tetrahedra);

    const Tetrahedron& operator[](std::uint32_t slot) const noexcept { return tetrahedra_[slot]; }
    std::uint32_t slotCount() const noexcept { return static_cast<std::uint32_t>(tetrahedra_.size()); }
    bool alive(std::uint32_t slot) const noexcept { return tetrahedra_[slot].vertices[0] != none; }
    /// Boundary triangles that ever were: they keep their numbers when a vertex of theirs moves.
    std::uint32_t triangleCount() const noexcept { return static_cast<std::uint32_t>(slotOfTriangle_.size()); }
    /// The tetrahedron that has a boundary triangle now.
    std::uint32_t slotOfTriangle(std::uint32_t triangle) const noexcept
    {
        return slotOfTriangle_[triangle - firstTriangle];
    }
    /// The corners of a boundary triangle, counterclockwise from outside.
    std::array<std::uint32_t, 3> cornersOf(std::uint32_t triangle) const noexcept;
    /// A tetrahedron of the vertex, or none.
    std::uint32_t slotOf(std::uint32_t vertex) const noexcept { return slotOfVertex_[vertex]; }

    /// The tetrahedra around a vertex that faces connect with slotOf(), which comes first.
    void findStar(std::uint32_t vertex, std::vector<std::uint32_t>& star) const;

    /// Moves `vertex` onto its neighbour `target`: tetrahedra of `star` that hold both vanish. No tetrahedron may have
    /// both of its faces opposite to them on the boundary.
    void collapse(std::uint32_t vertex, std::uint32_t target, std::span<const std::uint32_t> star);

private:
    void joinAcross(std::uint32_t slot, std::uint32_t vertex, std::uint32_t target);
    void replaceNeighbour(std::uint32_t slot, std::uint32_t before, std::uint32_t after);

    std::vector<Tetrahedron> tetrahedra_;
    std::vector<std::uint32_t> slotOfVertex_;
    std::vector<std::uint32_t> slotOfTriangle_;
    mutable std::vector<std::uint32_t> stamps_; ///< by slot: when it was in a star last
    mutable std::uint32_t stamp_ = 0;
};

/// Which of four different ones it is; 0 if none.
inline std::size_t indexOf(const std::array<std::uint32_t, 4>& four, std::uint32_t one) noexcept
{
    return std::size_t{four[1] == one} + 2 * std::size_t{four[2] == one} + 3 * std::size_t{four[3] == one};
}

} // namespace tetra
