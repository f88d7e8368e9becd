// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/object_values.h"

#include <tan/render.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

namespace {

/// Spread evenly over the sphere: along a spiral by the golden angle.
std::vector<Eigen::Vector3d> directionsAround(int count)
{
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Eigen::Vector3d> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, radius = std::sqrt(1 - z * z);
        directions.emplace_back(radius * std::cos(turn * i), radius * std::sin(turn * i), z);
    }
    return directions;
}

/// The farthest in each direction of the vertices that `belongs` says yes to, each once.
template <class Belongs> std::vector<Eigen::Vector3d> farthestOut(const TetrahedralMesh& mesh, Belongs belongs)
{
    constexpr int directionCount = 128;
    const std::vector<Eigen::Vector3d> directions = directionsAround(directionCount);
    std::vector<double> farthest(directions.size(), -std::numeric_limits<double>::infinity());
    std::vector<std::size_t> vertices(directions.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        const Eigen::Vector3d& position = mesh.positions[vertex];
        if (!belongs(vertex) || !position.allFinite())
            continue;
        for (std::size_t i = 0; i < directions.size(); ++i)
            if (const double distance = directions[i].dot(position); distance > farthest[i]) {
                farthest[i] = distance;
                vertices[i] = vertex;
            }
    }
    std::vector<Eigen::Vector3d> places;
    if (std::isinf(farthest.front()))
        return places;
    std::ranges::sort(vertices);
    const auto repeated = std::ranges::unique(vertices);
    vertices.erase(repeated.begin(), repeated.end());
    for (const std::size_t vertex : vertices)
        places.push_back(mesh.positions[vertex]);
    return places;
}

/// A little farther from their middle: what is seen may end between a vertex of the object and the next one.
std::vector<Eigen::Vector3d> withRoom(std::vector<Eigen::Vector3d> places)
{
    constexpr double room = 0.03;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : places)
        box.extend(place);
    for (Eigen::Vector3d& place : places)
        place += room * (place - box.center());
    return places;
}

double diagonalOf(std::span<const Eigen::Vector3d> places)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : places)
        if (place.allFinite())
            box.extend(place);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

} // namespace

std::vector<Eigen::Vector3d> objectOutline(const TetrahedralMesh& mesh, const ValueHistogram& volumes,
                                           std::optional<double> surface)
{
    constexpr double tiny = 1.0 / 16, nearlyAll = 0.9;
    const ObjectValues object(volumes, surface);
    if (!object.isBesideBackground())
        return {};
    const auto places =
        farthestOut(mesh, [&](std::size_t vertex) { return object.has(static_cast<double>(mesh.values[vertex])); });
    const double share = diagonalOf(places) / diagonalOf(mesh.positions);
    return share > tiny && share < nearlyAll ? withRoom(places) : std::vector<Eigen::Vector3d>();
}

} // namespace tetra
