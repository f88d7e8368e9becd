// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_shape.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr MarkedText lookingForOpenings = Message::marked("Looking for openings");
constexpr std::size_t trianglesAtOnce = std::size_t(1) << 16;
constexpr std::size_t verticesAtOnce = std::size_t(1) << 13;

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

/// The edges of all triangles by their smaller ends: of each vertex the larger ends, each as often as there are
/// triangles at the edge.
class EdgesByVertex {
public:
    /// Incomplete if cancelled.
    EdgesByVertex(const TriangleMesh& surface, const Progress& progress) : places_(surface.positions.size() + 1, 0)
    {
        forEach(surface, progress, [this](std::uint32_t smaller, std::uint32_t) { ++places_[smaller + 1]; });
        std::partial_sum(places_.begin(), places_.end(), places_.begin());
        larger_.resize(places_.back());
        forEach(surface, progress, [this](std::uint32_t smaller, std::uint32_t larger) {
            larger_[places_[smaller]++] = larger; // so each place moves to where the next vertex began
        });
    }

    std::span<std::uint32_t> of(std::size_t vertex)
    {
        const std::size_t first = vertex == 0 ? 0 : places_[vertex - 1];
        return {larger_.data() + first, places_[vertex] - first};
    }

private:
    template <class Visit> static void forEach(const TriangleMesh& surface, const Progress& progress, Visit&& visit)
    {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            if (t % trianglesAtOnce == 0 && progress.cancelled())
                return;
            const auto& [a, b, c] = surface.triangles[t];
            for (const auto& [one, other] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
                visit(std::min(one, other), std::max(one, other));
        }
    }

    std::vector<std::size_t> places_;
    Buffer<std::uint32_t> larger_;
};

struct EdgeFindings {
    std::vector<EdgeKey> open;
    std::uint64_t crowded = 0;
};

/// `larger` are of one vertex, and are sorted by this.
void findEdges(std::uint32_t vertex, std::span<std::uint32_t> larger, EdgeFindings& found)
{
    std::ranges::sort(larger);
    for (auto begin = larger.begin(); begin != larger.end();) {
        const auto end = std::find_if(begin, larger.end(), [begin](std::uint32_t other) { return other != *begin; });
        if (end - begin == 1)
            found.open.push_back(edgeKey(vertex, *begin));
        found.crowded += end - begin > 2 ? 1 : 0;
        begin = end;
    }
}

void countEdges(const TriangleMesh& surface, const Progress& progress, SurfaceShape& shape)
{
    EdgesByVertex edges(surface, progress);
    tbb::enumerable_thread_specific<EdgeFindings> found;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.positions.size(), verticesAtOnce),
                      [&](const auto& range) {
                          if (progress.cancelled())
                              return;
                          EdgeFindings& mine = found.local();
                          for (std::size_t vertex = range.begin(); vertex != range.end(); ++vertex)
                              findEdges(static_cast<std::uint32_t>(vertex), edges.of(vertex), mine);
                      });
    std::vector<EdgeKey> open;
    for (const EdgeFindings& one : found) {
        open.insert(open.end(), one.open.begin(), one.open.end());
        shape.crowdedEdges += one.crowded;
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

SurfaceShape shapeOf(const TriangleMesh& surface, const Progress& progress)
{
    constexpr double joined = 0.3, measured = 0.6;
    SurfaceShape shape;
    progress.report(0, lookingForOpenings);
    DisjointSets sets = joinedByTriangles(surface);
    std::vector<bool> isKnown(surface.positions.size(), false);
    const Eigen::Vector3d reference = referenceOf(surface);
    progress.report(joined, lookingForOpenings);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (t % trianglesAtOnce == 0 && progress.cancelled())
            return shape;
        const Triangle& triangle = surface.triangles[t];
        const std::uint32_t root = sets.root(triangle[0]);
        shape.parts += isKnown[root] ? 0 : 1;
        isKnown[root] = true;
        shape.area += areaOf(surface, triangle);
        shape.volume += volumeFrom(reference, surface, triangle);
    }
    progress.report(measured, lookingForOpenings);
    countEdges(surface, progress, shape);
    progress.report(1, lookingForOpenings);
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
