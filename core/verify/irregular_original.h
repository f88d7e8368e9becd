// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/verify/scattered_cells.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// A triangle by the numbers of three points, counterclockwise seen from outside.
using PointTriangle = std::array<std::uint32_t, 3>;

/// The closed surfaces that make up a boundary, what holds of each, and what is wrong with them.
struct BoundarySurfaces {
    struct Surface {
        std::uint32_t firstTriangle = 0; ///< its first one
        std::int64_t euler = 0;          ///< vertices - edges + triangles: 2 for a sphere, 0 for a torus
    };
    std::vector<Surface> surfaces;
    std::vector<std::uint32_t> surfaceOf; ///< of each triangle
    /// Edges that do not belong to two triangles of opposite directions, and vertices whose triangles are not one fan:
    /// by their points. With any, the surfaces mean nothing.
    std::vector<std::array<std::uint32_t, 2>> brokenEdges;
    std::vector<std::uint32_t> brokenVertices;
    bool isManifold() const noexcept { return brokenEdges.empty() && brokenVertices.empty(); }
};

/// Joins triangles over their edges. O(n log n).
BoundarySurfaces boundarySurfaces(std::span<const PointTriangle> triangles);

/// The corners of a triangle.
using TriangleCorners = std::array<Eigen::Vector3d, 3>;

/// A place of a triangle, as weights of its corners, and how far it is.
struct TrianglePlace {
    std::array<double, 3> weights{};
    double distance = 0;
};

/// The place next to `from`, in doubles.
TrianglePlace nearestPlace(const TriangleCorners& triangle, const Eigen::Vector3d& from);

/// Least and largest of the linear function with these values at the corners among the places at most `radius` from
/// `centre`, in doubles; none if there is no such place.
std::optional<std::array<double, 2>> valuesWithin(const TriangleCorners& triangle, const std::array<double, 3>& values,
                                                  const Eigen::Vector3d& centre, double radius);

/// Triangles in a tree of their boxes, to find those near a place. For verification. Safe to ask from any number of
/// threads.
class TriangleTree {
public:
    /// Both outlive it.
    TriangleTree(std::span<const Eigen::Vector3d> positions, std::span<const PointTriangle> triangles);

    struct Nearest {
        std::uint32_t triangle = 0;
        TrianglePlace place{{}, std::numeric_limits<double>::infinity()};
    };
    /// The first one at an infinite distance if there are no triangles.
    Nearest nearest(const Eigen::Vector3d& from) const;
    /// The same, quicker if the triangle `hint` is near.
    Nearest nearest(const Eigen::Vector3d& from, std::uint32_t hint) const;

    /// Calls visit(triangle) for each triangle whose box has a place in common with the box.
    template <class Visit> void visitMeeting(const Eigen::AlignedBox3d& box, Visit&& visit) const
    {
        visitIf([&box](const Eigen::AlignedBox3d& other) { return box.intersects(other); }, visit);
    }
    /// Calls visit(triangle) for each triangle that has a place within `radius`, and for some more.
    template <class Visit> void visitWithin(const Eigen::Vector3d& from, double radius, Visit&& visit) const
    {
        constexpr double roundedUp = 1 + 1e-14;
        visitIf([&from, squared = radius * radius * roundedUp](
                    const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(from) <= squared; },
                visit);
    }

    TriangleCorners corners(std::uint32_t triangle) const
    {
        const PointTriangle& t = triangles_[triangle];
        return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
    }
    Eigen::AlignedBox3d boxOf(std::uint32_t triangle) const;

private:
    Nearest nearestOf(const Eigen::Vector3d& from, Nearest best) const;

    template <class Test, class Visit> void visitIf(const Test& test, const Visit& visit) const
    {
        tree_.visitNear(test, [&](std::uint32_t triangle) {
            if (test(boxOf(triangle)))
                visit(triangle);
        });
    }

    std::span<const Eigen::Vector3d> positions_;
    std::span<const PointTriangle> triangles_;
    BoxTree tree_;
};

/// The original of a model of irregular data, ready to be compared with. The dataset outlives it.
struct IrregularOriginal {
    /// `dataset` has tetrahedra; what is wrong with them is appended to `failures`.
    IrregularOriginal(const Dataset& dataset, std::vector<std::string>& failures);

    static constexpr std::uint32_t none = 0xffffffff;

    ScatteredOriginal points;
    std::vector<PointTriangle> boundary;
    BoundarySurfaces surfaces;
    std::vector<std::uint32_t> surfaceOf;   ///< of each point; none inside
    std::vector<std::uint32_t> componentOf; ///< of each point, the smallest point that it is joined with
    TriangleTree tree;                      ///< of `boundary`
    double diagonal = 0;
    double allowance = 0; ///< by which a claimed warping may be exceeded: coordinates are rounded

    bool isOnBoundary(std::uint32_t point) const { return surfaceOf[point] != none; }
};

} // namespace tetra
