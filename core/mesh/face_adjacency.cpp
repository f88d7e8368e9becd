// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_adjacency.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <compare>

namespace tetra {
namespace {

/// A face among those of one smallest vertex.
struct DealtFace {
    std::uint32_t middle;
    std::uint32_t largest;
    std::uint32_t name; ///< cell * 4 + face
    auto operator<=>(const DealtFace&) const = default;
    bool sameCorners(const DealtFace& other) const { return middle == other.middle && largest == other.largest; }
};

std::array<std::uint32_t, 3> sortedCorners(const std::array<std::uint32_t, 4>& cell, std::size_t face)
{
    const auto& corners = cornersOfFace[face];
    const std::uint32_t a = cell[corners[0]], b = cell[corners[1]], c = cell[corners[2]];
    const std::uint32_t smallest = std::min({a, b, c});
    const std::uint32_t largest = std::max({a, b, c});
    return {smallest, a ^ b ^ c ^ smallest ^ largest, largest};
}

/// Where each vertex's faces begin, and after the last vertex the end.
Buffer<std::uint32_t> placesOfVertices(std::span<const std::array<std::uint32_t, 4>> cells, std::size_t vertexCount)
{
    Buffer<std::uint32_t> places(vertexCount + 2);
    std::ranges::fill(places, 0u);
    for (const auto& cell : cells)
        for (std::size_t face = 0; face < 4; ++face)
            ++places[sortedCorners(cell, face)[0] + 2];
    for (std::size_t v = 2; v < places.size(); ++v)
        places[v] += places[v - 1];
    return places;
}

} // namespace

FaceAdjacency matchFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::size_t vertexCount)
{
    FaceAdjacency adjacency;
    adjacency.neighbours.resize(tetrahedra.size());
    std::ranges::fill(adjacency.neighbours, std::array{adjacency.none, adjacency.none, adjacency.none, adjacency.none});

    Buffer<std::uint32_t> places = placesOfVertices(tetrahedra, vertexCount);
    Buffer<DealtFace> faces(4 * tetrahedra.size());
    for (std::size_t cell = 0; cell < tetrahedra.size(); ++cell)
        for (std::uint32_t face = 0; face < 4; ++face) {
            const auto [smallest, middle, largest] = sortedCorners(tetrahedra[cell], face);
            faces[places[smallest + 1]++] = {middle, largest, static_cast<std::uint32_t>(cell * 4 + face)};
        }

    std::atomic<std::size_t> surplus = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertexCount, 1024), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            const auto ofVertex = std::span(faces).subspan(places[v], places[v + 1] - places[v]);
            std::ranges::sort(ofVertex);
            for (std::size_t i = 1; i < ofVertex.size(); ++i) {
                const DealtFace& one = ofVertex[i - 1];
                const DealtFace& other = ofVertex[i];
                if (!one.sameCorners(other))
                    continue;
                adjacency.neighbours[one.name >> 2][one.name & 3] = other.name;
                adjacency.neighbours[other.name >> 2][other.name & 3] = one.name;
                for (++i; i < ofVertex.size() && ofVertex[i].sameCorners(other); ++i)
                    ++surplus;
            }
        }
    });
    adjacency.surplusFaces = surplus;
    return adjacency;
}

} // namespace tetra
