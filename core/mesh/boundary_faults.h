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

/// Where a closed surface, the boundary of positive tetrahedra that match, shows that they overlap.
struct BoundaryFaults {
    std::vector<std::array<std::uint32_t, 2>> meetings; ///< pairs of triangles that meet where they share nothing
    /// A triangle of each component whose outer side is inside of other tetrahedra; looked for if none meet.
    std::vector<std::uint32_t> buried;
};

/// Together with matching faces and a manifold boundary, finding no fault proves that the tetrahedra cover what
/// they cover once: how many of them lie over a point is the boundary's winding number there, which only changes at the
/// boundary, by one, and is zero just outside each of its components. Exact, but for which side of a closed surface is
/// the inner one, which its volume in doubles tells. Ends early when cancelled, and with 100,000 meetings; expected
/// O(n log n) for a surface that does not meet itself much. `triangles` are a manifold, seen from outside
/// counterclockwise.
BoundaryFaults findBoundaryFaults(std::span<const Eigen::Vector3d> positions,
                                  std::span<const SurfaceTriangle> triangles, const Progress& progress);

/// BoundaryFaults::buried of a surface that does not meet itself. O(n), if it is of one component.
std::vector<std::uint32_t> findBuried(std::span<const Eigen::Vector3d> positions,
                                      std::span<const SurfaceTriangle> triangles, const Progress& progress);

} // namespace tetra
