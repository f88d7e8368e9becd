// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_shape.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tetra {
namespace {

/// The vertices in sets by what the triangles join.
DisjointSets joinedByTriangles(const TriangleMesh& surface)
{
    DisjointSets sets(surface.positions.size());
    for (const auto& [a, b, c] : surface.triangles) {
        sets.join(a, b);
        sets.join(b, c);
    }
    return sets;
}

double areaOf(const TriangleMesh& surface, const Triangle& triangle)
{
    const Eigen::Vector3d& a = surface.positions[triangle[0]];
    return (surface.positions[triangle[1]] - a).cross(surface.positions[triangle[2]] - a).norm() / 2;
}

/// Of the tetrahedron from there to the triangle; negative if that looks there.
double volumeFrom(const Eigen::Vector3d& reference, const TriangleMesh& surface, const Triangle& triangle)
{
    const auto from = [&](std::size_t corner) -> Eigen::Vector3d {
        return surface.positions[triangle[corner]] - reference;
    };
    return from(0).dot(from(1).cross(from(2))) / 6;
}

/// Volumes are reckoned from there, as from far away they would be differences of large numbers.
Eigen::Vector3d referenceOf(const TriangleMesh& surface)
{
    return surface.positions.empty() ? Eigen::Vector3d(0, 0, 0) : surface.positions.front();
}

void countEdges(const TriangleMesh& surface, SurfaceShape& shape)
{
    Buffer<EdgeKey> edges;
    edges.reserve(3 * surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles)
        edges.insert(edges.end(), {edgeKey(a, b), edgeKey(b, c), edgeKey(c, a)});
    tbb::parallel_sort(edges.begin(), edges.end());
    std::vector<EdgeKey> open;
    for (auto begin = edges.begin(); begin != edges.end();) {
        const auto end = std::find_if(begin, edges.end(), [begin](EdgeKey edge) { return edge != *begin; });
        if (end - begin == 1)
            open.push_back(*begin);
        shape.crowdedEdges += end - begin > 2 ? 1 : 0;
        begin = end;
    }
    shape.openEdges = open.size();
    DisjointSets rims(open.empty() ? 0 : surface.positions.size());
    for (const EdgeKey edge : open) {
        const auto [a, b] = endsOf(edge);
        rims.join(a, b);
    }
    std::vector<std::uint32_t> roots;
    for (const EdgeKey edge : open)
        roots.push_back(rims.root(endsOf(edge)[0]));
    std::ranges::sort(roots);
    shape.openings = static_cast<std::uint64_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

} // namespace

SurfaceShape shapeOf(const TriangleMesh& surface)
{
    SurfaceShape shape;
    DisjointSets sets = joinedByTriangles(surface);
    std::vector<bool> isKnown(surface.positions.size(), false);
    const Eigen::Vector3d reference = referenceOf(surface);
    for (const Triangle& triangle : surface.triangles) {
        const std::uint32_t root = sets.root(triangle[0]);
        shape.parts += isKnown[root] ? 0 : 1;
        isKnown[root] = true;
        shape.area += areaOf(surface, triangle);
        shape.volume += volumeFrom(reference, surface, triangle);
    }
    countEdges(surface, shape);
    return shape;
}

void keepLargestPart(TriangleMesh& surface, SurfaceParts among)
{
    DisjointSets sets = joinedByTriangles(surface);
    struct Part {
        double volume = 0, area = 0;
    };
    std::vector<Part> parts(surface.positions.size()); // at their roots
    for (const Triangle& triangle : surface.triangles) {
        const std::uint32_t root = sets.root(triangle[0]);
        parts[root].volume += volumeFrom(surface.positions[root], surface, triangle);
        parts[root].area += areaOf(surface, triangle);
    }
    const auto rank = [among](const Part& part) {
        return std::pair(among == SurfaceParts::All || part.volume > 0, part.area);
    };
    const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(parts, {}, rank) - parts.begin());
    std::erase_if(surface.triangles, [&](const Triangle& triangle) { return sets.root(triangle[0]) != largest; });
    const std::vector<std::uint32_t> used = renumberUsed(surface.triangles, surface.positions.size());
    const auto keep = [&used](auto& ofVertices) {
        if (ofVertices.empty())
            return;
        for (std::size_t i = 0; i < used.size(); ++i)
            ofVertices[i] = ofVertices[used[i]];
        ofVertices.resize(used.size());
    };
    keep(surface.positions);
    keep(surface.normals);
    keep(surface.values);
    keep(surface.colours);
}

} // namespace tetra
