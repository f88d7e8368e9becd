// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangles.h"

#include <tan/base.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Triangles to find those that another one meets. O(n log^2 n) to build; asking is safe from any number of threads.
class TriangleBoxes {
public:
    /// Positions and triangles outlive it.
    TriangleBoxes(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles);

    static Eigen::AlignedBox3d boxOf(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& triangle);
    std::span<const Eigen::AlignedBox3d> boxes() const noexcept { return boxes_; }
    const BoxTree& tree() const noexcept { return tree_; }

    /// Calls visit(number) for each that the triangle meets (surfaceTrianglesMeet()) and of which `asked` says yes.
    template <class Asked, class Visit>
    void visitMeeting(const SurfaceTriangle& triangle, const Asked& asked, const Visit& visit) const
    {
        const Eigen::AlignedBox3d box = boxOf(positions_, triangle);
        const auto near = [&box](const Eigen::AlignedBox3d& other) { return box.intersects(other); };
        tree_.visitNear(near, [&](std::uint32_t other) {
            if (asked(other) && near(boxes_[other]) && surfaceTrianglesMeet(positions_, triangle, triangles_[other]))
                visit(other);
        });
    }

private:
    std::span<const Eigen::Vector3d> positions_;
    std::span<const SurfaceTriangle> triangles_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    BoxTree tree_;
};

/// Which triangles of a surface meet or touch others elsewhere than in the corner or edge that they share; all, if
/// there are more than 100,000 such pairs. Exact. Ends early when cancelled; expected O(n log n) for a surface that
/// does not meet itself much.
std::vector<bool> findTouched(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles,
                              const Progress& progress);

/// Of a closed surface, the boundary of positive tetrahedra that match: a triangle of each piece with something on its
/// outer side. `touched` as by findTouched(), or empty if nothing is; touched triangles are left out.
///
/// How many tetrahedra lie over a point changes only at the boundary, by one. So no two overlap if there are none on
/// the outer side of each triangle. In a piece (surfacePieces()), which nothing else touches, there are everywhere as
/// many, and a triangle of it tells how many: as often as the surface winds around a point just outside. What is beside
/// touched triangles, the tetrahedra there have to tell. O(n log n), if there are few pieces.
std::vector<std::uint32_t> findBuried(std::span<const Eigen::Vector3d> positions,
                                      std::span<const SurfaceTriangle> triangles, const std::vector<bool>& touched,
                                      const Progress& progress);

} // namespace tetra
