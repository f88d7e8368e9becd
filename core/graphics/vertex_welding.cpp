// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/vertex_welding.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <vector>

namespace tetra {
namespace {

constexpr std::size_t grain = 1 << 13;

double crossingFraction(double first, double second, double isovalue)
{
    const double fraction = (isovalue - first) / (second - first);
    return fraction >= 0 && fraction <= 1 ? fraction : 0.5;
}

/// The vertices that coincide with a mesh vertex, beside it; sorted.
struct Tie {
    std::uint32_t meshVertex;
    std::uint32_t vertex;
    auto operator<=>(const Tie&) const = default;
};

std::vector<Tie> findTies(const CrossingPoints& points)
{
    std::vector<Tie> ties;
    for (std::size_t v = 0; v < points.meshVertices.size(); ++v)
        if (points.meshVertices[v] != CrossingPoints::none)
            ties.push_back({points.meshVertices[v], static_cast<std::uint32_t>(v)});
    tbb::parallel_sort(ties);
    return ties;
}

/// The new number of each vertex; those that are welded get the number of the first of their place.
Buffer<std::uint32_t> newNumbers(const std::vector<Tie>& ties, std::size_t vertexCount, std::vector<bool>& kept)
{
    Buffer<std::uint32_t> first(vertexCount);
    for (std::size_t v = 0; v < vertexCount; ++v)
        first[v] = static_cast<std::uint32_t>(v);
    for (std::size_t i = 1; i < ties.size(); ++i)
        if (ties[i].meshVertex == ties[i - 1].meshVertex)
            first[ties[i].vertex] = first[ties[i - 1].vertex];

    std::uint32_t next = 0;
    Buffer<std::uint32_t> numbers(vertexCount);
    for (std::size_t v = 0; v < vertexCount; ++v) {
        kept[v] = first[v] == v; // the first of a place has the smallest number, so it is numbered already
        numbers[v] = kept[v] ? next++ : numbers[first[v]];
    }
    return numbers;
}

template <class T> void keepOnly(Buffer<T>& buffer, const std::vector<bool>& kept)
{
    std::size_t size = 0;
    for (std::size_t i = 0; i < buffer.size(); ++i)
        if (kept[i])
            buffer[size++] = buffer[i];
    buffer.resize(size);
}

} // namespace

CrossingPoints crossingPoints(const TetrahedralMesh& mesh, const EdgeVertices& vertices, double isovalue)
{
    CrossingPoints points;
    points.positions.resize(vertices.edges.size());
    points.fractions.resize(vertices.edges.size());
    points.meshVertices.resize(vertices.edges.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.edges.size(), grain), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            const auto [a, b] = vertices.edges[v];
            const double fraction = crossingFraction(mesh.values[a], mesh.values[b], isovalue);
            const Eigen::Vector3d from = mesh.positions[a].cast<double>();
            const Eigen::Vector3d to = mesh.positions[b].cast<double>();
            const Eigen::Vector3f position = (from + fraction * (to - from)).cast<float>();
            points.positions[v] = position;
            points.fractions[v] = static_cast<float>(fraction);
            points.meshVertices[v] = position == mesh.positions[a]   ? a
                                     : position == mesh.positions[b] ? b
                                                                     : CrossingPoints::none;
        }
    });
    return points;
}

void weldAtMeshVertices(EdgeVertices& vertices, CrossingPoints& points)
{
    const std::vector<Tie> ties = findTies(points);
    if (ties.empty())
        return;
    std::vector<bool> kept(vertices.edges.size());
    const Buffer<std::uint32_t> numbers = newNumbers(ties, vertices.edges.size(), kept);
    keepOnly(vertices.edges, kept);
    keepOnly(points.positions, kept);
    keepOnly(points.fractions, kept);
    keepOnly(points.meshVertices, kept);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.cornerVertex.size(), grain), [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c)
            vertices.cornerVertex[c] = numbers[vertices.cornerVertex[c]];
    });
}

} // namespace tetra
