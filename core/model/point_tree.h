// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Points halved again and again along the longest side of their box, to find those that may lie in a tetrahedron. For
/// verification. Safe to ask from any number of threads.
class PointTree {
public:
    /// The points outlive it.
    explicit PointTree(std::span<const Eigen::Vector3d> points);

    /// Calls visit(point) for every point in the tetrahedron, and for some near it.
    template <class Visit> void visitNear(const std::array<Eigen::Vector3d, 4>& corners, Visit&& visit) const
    {
        if (!points_.empty())
            descend(0, 0, static_cast<std::uint32_t>(points_.size()), Planes(corners), visit);
    }

private:
    static constexpr std::uint32_t leafSize = 8;

    /// The planes of a positive tetrahedron and its box, as a quick test that never rejects what is inside.
    class Planes {
    public:
        explicit Planes(const std::array<Eigen::Vector3d, 4>& corners);
        bool mayMeet(const Eigen::AlignedBox3d& box) const;

    private:
        std::array<Eigen::Vector3d, 4> origins_;
        std::array<Eigen::Vector3d, 4> normals_;    ///< inwards
        std::array<Eigen::Vector3d, 4> magnitudes_; ///< what the normals' rounding errors are relative to
        Eigen::AlignedBox3d box_;
    };

    void build(std::size_t node, std::uint32_t first, std::uint32_t end);

    template <class Visit>
    void descend(std::size_t node, std::uint32_t first, std::uint32_t end, const Planes& planes, Visit&& visit) const
    {
        if (!planes.mayMeet(boxes_[node]))
            return;
        if (end - first <= leafSize) {
            for (std::uint32_t i = first; i < end; ++i)
                visit(order_[i]);
            return;
        }
        const std::uint32_t middle = first + (end - first) / 2;
        descend(2 * node + 1, first, middle, planes, visit);
        descend(2 * node + 2, middle, end, planes, visit);
    }

    std::span<const Eigen::Vector3d> points_;
    std::vector<std::uint32_t> order_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< node n has the children 2n + 1 and 2n + 2
};

} // namespace tetra
