// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/edge_vertices.h"

#include "core/graphics/marching_cases.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace tetra {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Enough to keep each part's hash table in the cache and many threads busy.
constexpr std::size_t partCount = 64;
constexpr int partBits = std::countr_zero(partCount);

std::uint64_t hashOf(const Edge& edge) noexcept
{
    const std::uint64_t key = std::uint64_t(edge[0]) << 32 | edge[1];
    const std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
    return (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
}

std::size_t partOf(std::uint64_t hash) noexcept
{
    return hash >> (64 - partBits);
}

/// Calls visit(corner number, edge) for each corner of the chunk.
template <class Visit> void forEachCorner(const TetrahedralMesh& mesh, const CrossedChunk& chunk,
                                          std::size_t chunkIndex, std::uint64_t firstCorner, Visit&& visit)
{
    auto corner = static_cast<std::uint32_t>(firstCorner);
    for (const std::uint32_t entry : chunk.entries) {
        const MarchingCase& marching = marchingCases[CrossedChunk::caseOf(entry)];
        const auto& sites = mesh.tetrahedra[chunkIndex * CrossedChunk::chunkSize + CrossedChunk::offsetOf(entry)];
        for (int i = 0; i < marching.corners; ++i) {
            const std::uint32_t a = sites[marching.edges[static_cast<std::size_t>(i)][0]];
            const std::uint32_t b = sites[marching.edges[static_cast<std::size_t>(i)][1]];
            visit(corner++, Edge{std::min(a, b), std::max(a, b)});
        }
    }
}

/// The corners, dealt to the parts; inside a part in their own order.
struct DealtCorners {
    std::array<std::uint64_t, partCount + 1> firstOfPart{};
    Buffer<Edge> edges;
    Buffer<std::uint32_t> corners;
};

using PartCounts = std::array<std::uint64_t, partCount>;

/// Turns counts per chunk and part into the places where each chunk's corners of each part begin.
std::array<std::uint64_t, partCount + 1> placesFromCounts(std::vector<PartCounts>& counts)
{
    std::array<std::uint64_t, partCount + 1> firstOfPart{};
    std::uint64_t place = 0;
    for (std::size_t part = 0; part < partCount; ++part) {
        firstOfPart[part] = place;
        for (PartCounts& ofChunk : counts) {
            const std::uint64_t count = ofChunk[part];
            ofChunk[part] = place;
            place += count;
        }
    }
    firstOfPart[partCount] = place;
    return firstOfPart;
}

DealtCorners deal(const TetrahedralMesh& mesh, std::span<const CrossedChunk> chunks,
                  const std::vector<std::uint64_t>& firstCorner)
{
    const tbb::blocked_range<std::size_t> allChunks(0, chunks.size());
    std::vector<PartCounts> places(chunks.size(), PartCounts{});
    tbb::parallel_for(allChunks, [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c)
            forEachCorner(mesh, chunks[c], c, firstCorner[c],
                          [&](std::uint32_t, const Edge& edge) { ++places[c][partOf(hashOf(edge))]; });
    });
    DealtCorners dealt;
    dealt.firstOfPart = placesFromCounts(places);
    dealt.edges.resize(firstCorner.back());
    dealt.corners.resize(firstCorner.back());
    tbb::parallel_for(allChunks, [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c)
            forEachCorner(mesh, chunks[c], c, firstCorner[c], [&](std::uint32_t corner, const Edge& edge) {
                const std::uint64_t place = places[c][partOf(hashOf(edge))]++;
                dealt.edges[place] = edge;
                dealt.corners[place] = corner;
            });
    });
    return dealt;
}

/// Numbers the edges of one part by their first appearance: the different edges move to the front of `edges`, and
/// numbers[i] becomes the number of edge i. Returns how many there are.
std::uint32_t numberPart(std::span<Edge> edges, std::span<std::uint32_t> numbers, std::vector<std::uint32_t>& slots)
{
    constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
    const std::size_t mask = std::bit_ceil(edges.size() + edges.size() / 2 + 1) - 1;
    slots.assign(mask + 1, empty);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge edge = edges[i];
        std::size_t slot = hashOf(edge) & mask;
        while (slots[slot] != empty && edges[slots[slot]] != edge)
            slot = (slot + 1) & mask;
        if (slots[slot] == empty) {
            slots[slot] = count;
            edges[count++] = edge;
        }
        numbers[i] = slots[slot];
    }
    return count;
}

} // namespace

EdgeVertices numberEdgeVertices(const TetrahedralMesh& mesh, std::span<const CrossedChunk> chunks)
{
    EdgeVertices result;
    result.firstCorner.push_back(0);
    for (const CrossedChunk& chunk : chunks)
        result.firstCorner.push_back(result.firstCorner.back() + chunk.corners);

    DealtCorners dealt = deal(mesh, chunks, result.firstCorner);
    const auto partSpan = [&](auto& buffer, std::size_t part) {
        return std::span(buffer).subspan(dealt.firstOfPart[part],
                                         dealt.firstOfPart[part + 1] - dealt.firstOfPart[part]);
    };
    const tbb::blocked_range<std::size_t> allParts(0, partCount, 1);
    Buffer<std::uint32_t> numbers(dealt.edges.size());
    std::array<std::uint32_t, partCount + 1> firstVertex{};
    tbb::parallel_for(allParts, [&](const auto& range) {
        std::vector<std::uint32_t> slots;
        for (std::size_t part = range.begin(); part != range.end(); ++part)
            firstVertex[part + 1] = numberPart(partSpan(dealt.edges, part), partSpan(numbers, part), slots);
    });
    for (std::size_t part = 0; part < partCount; ++part)
        firstVertex[part + 1] += firstVertex[part];

    result.edges.resize(firstVertex[partCount]);
    result.cornerVertex.resize(dealt.edges.size());
    tbb::parallel_for(allParts, [&](const auto& range) {
        for (std::size_t part = range.begin(); part != range.end(); ++part) {
            std::copy_n(partSpan(dealt.edges, part).begin(), firstVertex[part + 1] - firstVertex[part],
                        result.edges.begin() + firstVertex[part]);
            const auto corners = partSpan(dealt.corners, part);
            const auto local = partSpan(numbers, part);
            for (std::size_t i = 0; i < corners.size(); ++i)
                result.cornerVertex[corners[i]] = firstVertex[part] + local[i];
        }
    });
    return result;
}

} // namespace tetra
