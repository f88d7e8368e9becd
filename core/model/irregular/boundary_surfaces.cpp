// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/boundary_surfaces.h"

#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

/// An edge as one of its triangles has it.
struct SurfaceEdge {
    std::array<std::uint32_t, 2> points; ///< the smaller number first
    bool turned;                         ///< it runs from the larger one to the smaller
    std::uint32_t triangle;
    std::uint32_t corner; ///< of the triangle, where it begins

    auto operator<=>(const SurfaceEdge&) const = default;
};

std::vector<SurfaceEdge> sortedEdges(std::span<const PointTriangle> triangles)
{
    std::vector<SurfaceEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangles[triangle][corner], to = triangles[triangle][(corner + 1) % 3];
            edges.push_back({{std::min(from, to), std::max(from, to)}, from > to, triangle, corner});
        }
    std::ranges::sort(edges);
    return edges;
}

/// Fans: the corners of triangles that follow each other around a vertex.
void joinFans(const SurfaceEdge& first, const SurfaceEdge& second, DisjointSets& fans)
{
    // The edge begins in one triangle where it ends in the other.
    const auto corner = [](const SurfaceEdge& edge, std::uint32_t step) {
        return 3 * edge.triangle + (edge.corner + step) % 3;
    };
    fans.join(corner(first, 0), corner(second, 1));
    fans.join(corner(first, 1), corner(second, 0));
}

/// The vertices of each triangle whose corners fall into more than one fan, sorted.
std::vector<std::uint32_t> verticesOfManyFans(std::span<const PointTriangle> triangles, DisjointSets& fans)
{
    std::vector<std::array<std::uint32_t, 2>> roots; // of a vertex
    for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner)
        roots.push_back({triangles[corner / 3][corner % 3], fans.root(corner)});
    std::ranges::sort(roots);
    roots.erase(std::ranges::unique(roots).begin(), roots.end());
    std::vector<std::uint32_t> broken;
    for (std::size_t i = 1; i < roots.size(); ++i)
        if (roots[i][0] == roots[i - 1][0] && (broken.empty() || broken.back() != roots[i][0]))
            broken.push_back(roots[i][0]);
    return broken;
}

/// Numbers the surfaces in the order of their first triangles, and counts what they have: every fan is a vertex.
void nameSurfaces(std::size_t triangleCount, DisjointSets& joined, DisjointSets& fans, BoundarySurfaces& found)
{
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> names(triangleCount, none);
    for (std::uint32_t triangle = 0; triangle < triangleCount; ++triangle) {
        std::uint32_t& name = names[joined.root(triangle)];
        if (name == none) {
            name = static_cast<std::uint32_t>(found.surfaces.size());
            found.surfaces.push_back({triangle, 0});
        }
        found.surfaceOf.push_back(name);
    }
    std::vector<std::int64_t> triangles(found.surfaces.size());
    for (std::uint32_t triangle = 0; triangle < triangleCount; ++triangle)
        ++triangles[found.surfaceOf[triangle]];
    for (std::size_t surface = 0; surface < triangles.size(); ++surface)
        found.surfaces[surface].euler = triangles[surface] - 3 * triangles[surface] / 2;
    for (std::uint32_t corner = 0; corner < 3 * triangleCount; ++corner)
        if (fans.root(corner) == corner)
            ++found.surfaces[found.surfaceOf[corner / 3]].euler;
}

} // namespace

BoundarySurfaces boundarySurfaces(std::span<const PointTriangle> triangles)
{
    BoundarySurfaces found;
    const std::vector<SurfaceEdge> edges = sortedEdges(triangles);
    DisjointSets joined(triangles.size());
    DisjointSets fans(3 * triangles.size());
    for (auto begin = edges.begin(); begin != edges.end();) {
        const auto end =
            std::find_if(begin, edges.end(), [&](const SurfaceEdge& edge) { return edge.points != begin->points; });
        if (end - begin == 2 && begin->turned != (end - 1)->turned) {
            joined.join(begin->triangle, (end - 1)->triangle);
            joinFans(*begin, *(end - 1), fans);
        } else {
            found.brokenEdges.push_back(begin->points);
        }
        begin = end;
    }
    if (found.brokenEdges.empty())
        found.brokenVertices = verticesOfManyFans(triangles, fans);
    nameSurfaces(triangles.size(), joined, fans, found);
    return found;
}

} // namespace tetra
