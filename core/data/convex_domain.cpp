// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/disjoint_sets.h"
#include "core/geometry/orientation.h"
#include "core/mesh/boundary.h"

#include <tan/data.h>

#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace tetra {

namespace {

/// The coordinates along one axis of space, which follow one index of a grid.
struct AxisCoordinates {
    int axis = 0; ///< of the grid
    std::vector<double> places;
};

/// Those of one coordinate along the edges of the grid that begin at its first point, if it changes along one of them
/// only, there without turning back.
std::optional<AxisCoordinates> alongOneAxis(const Dataset& grid, int coordinate)
{
    std::optional<AxisCoordinates> found;
    for (int axis = 0; axis < 3; ++axis) {
        AxisCoordinates along{axis, {}};
        for (std::uint32_t i = 0; i < grid.lattice.size[static_cast<std::size_t>(axis)]; ++i) {
            std::array<std::uint32_t, 3> place{};
            place[static_cast<std::size_t>(axis)] = i;
            along.places.push_back((*grid.positions)[grid.lattice.index(place[0], place[1], place[2])][coordinate]);
        }
        if (std::ranges::adjacent_find(along.places, std::not_equal_to<>()) == along.places.end())
            continue;
        const bool goesOn = std::ranges::adjacent_find(along.places, std::greater_equal<>()) == along.places.end() ||
                            std::ranges::adjacent_find(along.places, std::less_equal<>()) == along.places.end();
        if (found || !goesOn)
            return std::nullopt;
        found = std::move(along);
    }
    return found;
}

bool isRectilinear(const Dataset& grid)
{
    std::array<AxisCoordinates, 3> coordinates;
    std::array<bool, 3> taken{};
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
        auto along = alongOneAxis(grid, coordinate);
        if (!along || std::exchange(taken[static_cast<std::size_t>(along->axis)], true))
            return false;
        coordinates[static_cast<std::size_t>(coordinate)] = *std::move(along);
    }
    std::uint64_t point = 0;
    std::array<std::uint32_t, 3> at{};
    const auto& size = grid.lattice.size;
    for (at[2] = 0; at[2] < size[2]; ++at[2])
        for (at[1] = 0; at[1] < size[1]; ++at[1])
            for (at[0] = 0; at[0] < size[0]; ++at[0], ++point)
                for (int coordinate = 0; coordinate < 3; ++coordinate) {
                    const auto& [axis, places] = coordinates[static_cast<std::size_t>(coordinate)];
                    if ((*grid.positions)[point][coordinate] != places[at[static_cast<std::size_t>(axis)]])
                        return false;
                }
    return true;
}

using Triangle = std::array<std::uint32_t, 3>;

/// An edge of a boundary, as a triangle has it.
struct BoundaryEdge {
    std::array<std::uint32_t, 2> ends; ///< ascending
    std::uint32_t opposite;            ///< the triangle's other vertex
    std::uint32_t triangle;
};

std::vector<BoundaryEdge> edgesOf(std::span<const Triangle> triangles)
{
    std::vector<BoundaryEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t number = 0; number < triangles.size(); ++number)
        for (std::size_t i = 0; i < 3; ++i) {
            const Triangle& t = triangles[number];
            const auto [first, second] = std::minmax(t[(i + 1) % 3], t[(i + 2) % 3]);
            edges.push_back({{first, second}, t[i], number});
        }
    std::ranges::sort(edges, {}, [](const BoundaryEdge& edge) { return std::tie(edge.ends, edge.triangle); });
    return edges;
}

/// A closed surface and what it may be bent inwards by.
class ConvexityCheck {
public:
    explicit ConvexityCheck(const Dataset& dataset)
        : positions_(*dataset.positions), faces_(boundaryFaces(positions_.size(), *dataset.tetrahedra)),
          tolerance_(1e-6 * dataset.bounds().diagonal().norm())
    {
    }

    bool run() const
    {
        const std::vector<BoundaryEdge> edges = edgesOf(faces_.triangles);
        DisjointSets joined(faces_.triangles.size());
        bool exact = true;
        for (std::size_t i = 0; i < edges.size(); i += 2) {
            if (i + 1 == edges.size() || edges[i].ends != edges[i + 1].ends)
                return false;
            const Bend bend = bendAt(edges[i].triangle, edges[i + 1].opposite);
            if (bend == Bend::Inwards)
                return false;
            exact = exact && bend == Bend::Outwards;
            joined.join(edges[i].triangle, edges[i + 1].triangle);
        }
        for (std::uint32_t triangle = 1; triangle < faces_.triangles.size(); ++triangle)
            if (joined.root(triangle) != joined.root(0))
                return false;
        // A closed surface that is bent outwards everywhere, or not at all, is the boundary of a convex body.
        return exact || isWithinTolerance();
    }

private:
    enum class Bend { Outwards, Hardly, Inwards };

    const Eigen::Vector3d& at(std::uint32_t vertex) const { return positions_[faces_.vertices[vertex]]; }

    double heightAbove(const Triangle& t, std::uint32_t vertex) const
    {
        const Eigen::Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
        const double length = normal.norm();
        return length > 0 ? normal.dot(at(vertex) - at(t[0])) / length : 0;
    }
    /// How the surface goes on from a triangle to the one whose other vertex is `beyond`.
    Bend bendAt(std::uint32_t triangle, std::uint32_t beyond) const
    {
        const Triangle& t = faces_.triangles[triangle];
        if (orientation(at(t[0]), at(t[1]), at(t[2]), at(beyond)) <= 0)
            return Bend::Outwards;
        return heightAbove(t, beyond) <= tolerance_ ? Bend::Hardly : Bend::Inwards;
    }
    /// Small bends may add up, so that every vertex is looked at from every face.
    bool isWithinTolerance() const
    {
        constexpr std::uint64_t mostPairs = 10'000'000'000;
        const auto vertices = static_cast<std::uint32_t>(faces_.vertices.size());
        if (std::uint64_t(vertices) * faces_.triangles.size() > mostPairs)
            return false;
        return tbb::parallel_reduce(
            tbb::blocked_range<std::size_t>(0, faces_.triangles.size()), true,
            [&](const auto& range, bool so) {
                for (std::size_t triangle = range.begin(); so && triangle != range.end(); ++triangle)
                    for (std::uint32_t vertex = 0; so && vertex < vertices; ++vertex)
                        so = heightAbove(faces_.triangles[triangle], vertex) <= tolerance_;
                return so;
            },
            std::logical_and<>());
    }

    std::span<const Eigen::Vector3d> positions_;
    BoundaryFaces faces_;
    double tolerance_;
};

} // namespace

bool hasConvexDomain(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::Curvilinear)
        return isRectilinear(dataset);
    return dataset.domain != DomainClass::Irregular || ConvexityCheck(dataset).run();
}

Dataset asPoints(const Dataset& dataset)
{
    Dataset points = dataset;
    points.domain = DomainClass::Scattered;
    points.lattice = {.size = {static_cast<std::uint32_t>(dataset.pointCount()), 1, 1}};
    points.tetrahedra = nullptr;
    points.faultyCells = nullptr;
    return points;
}

} // namespace tetra
