// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/vertex_welding.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace tetra {
namespace {

constexpr std::size_t tiesAtOnce = 1 << 13;
constexpr std::uint32_t welded = 0xffffffff;

/// The new number of each vertex; those that are welded get the number of the first of their place. Their positions
/// and normals go.
Buffer<std::uint32_t> renumberVertices(std::span<const Tie> ties, TriangleMesh& surface)
{
    const std::size_t count = surface.positions.size();
    Buffer<std::uint32_t> numbers(count);
    std::ranges::fill(numbers, 0u);
    for (std::size_t i = 1; i < ties.size(); ++i)
        if (ties[i].meshVertex == ties[i - 1].meshVertex)
            numbers[ties[i].vertex] = welded;
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < count; ++v) {
        if (numbers[v] == welded)
            continue;
        surface.positions[next] = surface.positions[v];
        surface.normals[next] = surface.normals[v];
        numbers[v] = next++;
    }
    surface.positions.resize(next);
    surface.normals.resize(next);
    for (std::size_t i = 1; i < ties.size(); ++i)
        if (ties[i].meshVertex == ties[i - 1].meshVertex)
            numbers[ties[i].vertex] = numbers[ties[i - 1].vertex]; // the first of a place has the smallest number
    return numbers;
}

} // namespace

void weldAtMeshVertices(std::span<const Tie> ties, TriangleMesh& surface)
{
    const Buffer<std::uint32_t> numbers = renumberVertices(ties, surface);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.triangles.size(), tiesAtOnce), [&](const auto& range) {
        for (std::size_t t = range.begin(); t != range.end(); ++t)
            for (std::uint32_t& corner : surface.triangles[t])
                corner = numbers[corner];
    });
    std::erase_if(surface.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

} // namespace tetra
