// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tetra::testing {

/// The places of a surface's triangles, each from its smallest corner on, all sorted.
inline std::vector<std::array<double, 9>> sortedTriangles(const TriangleMesh& surface)
{
    std::vector<std::array<double, 9>> triangles;
    for (const auto& triangle : surface.triangles) {
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis)
                corners[i][std::size_t(axis)] = surface.positions[triangle[i]][axis];
        std::ranges::rotate(corners, std::ranges::min_element(corners));
        auto& flat = triangles.emplace_back();
        for (std::size_t i = 0; i < 9; ++i)
            flat[i] = corners[i / 3][i % 3];
    }
    std::ranges::sort(triangles);
    return triangles;
}

/// The normals by the places of their vertices.
inline std::vector<std::array<double, 6>> sortedNormals(const TriangleMesh& surface)
{
    std::vector<std::array<double, 6>> vertices;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const auto& p = surface.positions[v];
        const auto& n = surface.normals[v];
        vertices.push_back({p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
    }
    std::ranges::sort(vertices);
    return vertices;
}

/// Whether two surfaces differ in nothing but the order of their vertices and triangles, normals left out.
inline bool sameSurface(const TriangleMesh& one, const TriangleMesh& other)
{
    return one.positions.size() == other.positions.size() && sortedTriangles(one) == sortedTriangles(other);
}

/// Whether the normals at the same places are the same, but for the rounding of sums in another order.
inline bool sameNormals(const TriangleMesh& one, const TriangleMesh& other)
{
    return std::ranges::equal(sortedNormals(one), sortedNormals(other), [](const auto& a, const auto& b) {
        return std::ranges::equal(a, b, [](double p, double q) { return std::abs(p - q) < 1e-3; });
    });
}

} // namespace tetra::testing
