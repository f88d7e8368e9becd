// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"
#include "core/geometry/triangles.h"
#include "core/mesh/topology.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The boundary triangles of a mesh while it is decimated, and whether a replacement makes the boundary meet itself
/// (S12). A loose octree: each triangle lies in one cell, as large as the triangle and around the middle of its box, so
/// that small and large ones get along; some 100 bytes a triangle. Concurrent questions are allowed, changes are not.
class BoundarySurface {
public:
    /// `positions` outlives the surface; `triangles` have an area each. O(n).
    BoundarySurface(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles);

    /// Whether, once `removed` were gone, one of `added` met another of them or one of the surface elsewhere than in
    /// the corner or edge that they share, or had no area. Exact. About O(what lies close by) for each added one.
    bool meetsItself(std::span<const SurfaceTriangle> added, std::span<const SurfaceTriangle> removed) const;

    /// Whether a triangle of the surface meets or touches another one elsewhere than in the corner or edge that they
    /// share. Exact.
    bool isTouched(const SurfaceTriangle& triangle) const { return meetsRest(triangle, std::span(&triangle, 1)); }

    /// Whether a triangle of the surface lies inside of one of the tetrahedra, whose faces it does not cross: a part
    /// that they have swallowed. In doubles, with room for rounding at the faces.
    bool liesInside(std::span<const Tetrahedron> tetrahedra) const;

    /// Each of `removed` is in the surface, in either orientation.
    void replace(std::span<const SurfaceTriangle> removed, std::span<const SurfaceTriangle> added);

    std::size_t size() const noexcept { return cells_.front().triangles; }

    void archive(StateArchive& archive) { archive(cells_, entries_, freeEntry_); }

private:
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    struct Cell {
        std::array<std::uint32_t, 8> children{none, none, none, none, none, none, none, none};
        std::uint32_t first = none;  ///< of its own triangles
        std::uint32_t triangles = 0; ///< with those of the children
    };
    struct Entry {
        SurfaceTriangle triangle{};
        std::uint32_t next = none;
    };
    /// Which cell a triangle lies in: its depth, and the numbers of a cell of the deepest level in it.
    struct Place {
        std::array<std::uint32_t, 3> numbers{};
        int depth = 0;
    };

    Place placeOf(const SurfaceTriangle& triangle) const;
    void insert(const SurfaceTriangle& triangle);
    void remove(const SurfaceTriangle& triangle);
    bool meetsRest(const SurfaceTriangle& triangle, std::span<const SurfaceTriangle> removed) const;
    template <class Passes, class Visit>
    bool anyNear(const Eigen::AlignedBox3d& box, const Passes& passes, const Visit& visit) const;
    bool meetsInCell(const Cell& cell, const SurfaceTriangle& triangle, const Eigen::AlignedBox3d& box,
                     std::span<const SurfaceTriangle> removed) const;

    std::span<const Eigen::Vector3d> positions_;
    Eigen::Vector3d corner_; ///< of the root, a cube
    double size_ = 1;        ///< of the root
    std::vector<Cell> cells_;
    std::vector<Entry> entries_;
    std::uint32_t freeEntry_ = none;
};

} // namespace tetra
