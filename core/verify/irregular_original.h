// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/mesh/topology.h"
#include "core/verify/exact_cell.h"

#include <tan/data.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// Some of the positions as the corners of a cell.
inline PlacedCell placedCell(std::span<const Eigen::Vector3d> positions, const Tetrahedron& points)
{
    return {positions[points[0]], positions[points[1]], positions[points[2]], positions[points[3]]};
}

template <std::size_t Count> Eigen::AlignedBox3d boxOf(const std::array<Eigen::Vector3d, Count>& corners)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : corners)
        box.extend(corner);
    return box;
}

/// The original points of a model of scattered or irregular data, ready to be looked for. The dataset outlives it.
struct ScatteredOriginal {
    explicit ScatteredOriginal(const Dataset& dataset);

    std::span<const Eigen::Vector3d> positions;
    std::vector<double> values;
    BoxTree tree; ///< of the positions
};

// Triangles are by numbers of points, counterclockwise seen from outside.

/// The surfaces that make up a boundary, what holds of each, and where they touch themselves or each other. Triangles
/// are of one surface that share an edge which belongs to them alone, in opposite directions: the others are seams, at
/// which surfaces end.
struct BoundarySurfaces {
    struct Surface {
        std::uint32_t firstTriangle = 0; ///< its first one
        std::int64_t euler = 0;          ///< vertices - edges + triangles: 2 for a sphere, 0 for a torus
        auto operator<=>(const Surface&) const = default;
    };
    std::vector<Surface> surfaces;
    std::vector<std::uint32_t> surfaceOf; ///< of each triangle
    /// Edges that are seams, by their points, and how many triangles have them. Sorted.
    std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> seams;
    /// Vertices whose triangles are several fans, and how many. Sorted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pinches;
    bool isPinched(std::uint32_t point) const
    {
        return std::ranges::binary_search(pinches, point, {}, [](const auto& pinch) { return pinch.first; });
    }
};

/// Joins triangles over their edges. O(n log n).
BoundarySurfaces boundarySurfaces(std::span<const Triangle> triangles);

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

/// Whether two triangles that are not flat have a place in common besides the points that they share by number: they
/// cross, touch, or lie on one another. Exact for all finite doubles. At most two points are shared.
bool facesMeet(std::span<const Eigen::Vector3d> positions, const Triangle& first, const Triangle& second);

/// Whether the segment and the triangle, which is not flat, have a place in common, their ends included. Exact.
bool segmentMeetsTriangle(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Triangles in a tree of their boxes, to find those near a place. For verification. Safe to ask from any number of
/// threads.
class TriangleTree {
public:
    /// Both outlive it.
    TriangleTree(std::span<const Eigen::Vector3d> positions, std::span<const Triangle> triangles);

    struct Nearest {
        std::uint32_t triangle = 0;
        TrianglePlace place{{}, std::numeric_limits<double>::infinity()};
    };
    /// The first one at an infinite distance if there are no triangles. Quicker if the triangle `hint` is near.
    Nearest nearest(const Eigen::Vector3d& from, std::optional<std::uint32_t> hint = {}) const;

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
        const Triangle& t = triangles_[triangle];
        return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
    }
    Eigen::AlignedBox3d boxOf(std::uint32_t triangle) const { return tetra::boxOf(corners(triangle)); }

private:
    template <class Test, class Visit> void visitIf(const Test& test, const Visit& visit) const
    {
        tree_.visitNear(test, [&](std::uint32_t triangle) {
            if (test(boxOf(triangle)))
                visit(triangle);
        });
    }

    std::span<const Eigen::Vector3d> positions_;
    std::span<const Triangle> triangles_;
    BoxTree tree_;
};

/// The original of a model of irregular data, ready to be compared with. The dataset outlives it.
struct IrregularOriginal {
    /// `dataset` has tetrahedra; what is wrong with them is appended to `failures`.
    IrregularOriginal(const Dataset& dataset, std::vector<std::string>& failures);

    static constexpr std::uint32_t none = 0xffffffff;

    ScatteredOriginal points;
    std::vector<Triangle> boundary;
    BoundarySurfaces surfaces;
    /// Of each point, one of those that it lies on; none inside. The others of a pinch are in `atPinches`.
    std::vector<std::uint32_t> surfaceOf;
    std::vector<std::array<std::uint32_t, 2>> atPinches; ///< a pinched point and a surface that it lies on, sorted
    std::vector<std::uint32_t> componentOf;              ///< of each point, the smallest point that it is joined with
    std::vector<std::uint32_t> touching;                 ///< touchingPoints()
    std::vector<Triangle> faces; ///< `boundary`, each with its points in increasing order, sorted
    TriangleTree tree;           ///< of `boundary`
    double diagonal;             ///< of the bounds

    bool isOnBoundary(std::uint32_t point) const { return surfaceOf[point] != none; }
    /// Whether it is one of `boundary`.
    bool isFace(Triangle triangle) const
    {
        std::ranges::sort(triangle);
        return std::ranges::binary_search(faces, triangle);
    }
};

/// How far a mesh's boundary goes from the original's.
struct BoundaryDistances {
    double found = 0; ///< the farthest place that was looked at
    double bound = 0; ///< no place is farther
};

/// From all places of `triangles`, by the points of the original, to the original's boundary. Triangles are cut until
/// what the bound says is at most a twentieth more than what was found, or a thousandth of the diagonal, or the pieces
/// are very small. The same with any number of threads.
BoundaryDistances distancesToOriginal(const IrregularOriginal& original, std::span<const Triangle> triangles);

} // namespace tetra
