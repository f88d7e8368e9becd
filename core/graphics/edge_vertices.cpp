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
constexpr std::size_t partCount = 32;
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

/// Numbers edges by their first appearance: the different ones move to the front of `edges`, and numbers[i] becomes the
/// number of edge i. Returns how many there are. `slots` is memory to use again.
std::uint32_t numberEdges(std::span<Edge> edges, std::span<std::uint32_t> numbers, std::vector<std::uint32_t>& slots)
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

/// The edge of each corner of a chunk.
void collectEdges(const TetrahedralMesh& mesh, const CrossedChunk& chunk, std::size_t chunkIndex, Buffer<Edge>& edges)
{
    edges.resize(chunk.corners);
    std::size_t next = 0;
    for (const std::uint32_t entry : chunk.entries) {
        const MarchingCase& marching = marchingCases[CrossedChunk::caseOf(entry)];
        const auto& sites = mesh.tetrahedra[chunkIndex * CrossedChunk::chunkSize + CrossedChunk::offsetOf(entry)];
        for (std::size_t i = 0; i < static_cast<std::size_t>(marching.corners); ++i) {
            const std::uint32_t a = sites[marching.edges[i][0]];
            const std::uint32_t b = sites[marching.edges[i][1]];
            edges[next++] = {std::min(a, b), std::max(a, b)};
        }
    }
}

/// The different edges of each chunk. Most corners that share an edge lie in one chunk, so this leaves few for the
/// parts, and each chunk's table fits the cache.
struct ChunkEdges {
    std::vector<std::vector<Edge>> edges;
    std::vector<std::uint64_t> first; ///< the number of edges in the chunks before, for each chunk; at the end of all
};

/// Also fills cornerVertex with numbers inside the chunk.
ChunkEdges numberInsideChunks(const TetrahedralMesh& mesh, std::span<const CrossedChunk> chunks, EdgeVertices& result)
{
    ChunkEdges unique;
    unique.edges.resize(chunks.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.size()), [&](const auto& range) {
        Buffer<Edge> edges;
        std::vector<std::uint32_t> slots;
        for (std::size_t c = range.begin(); c != range.end(); ++c) {
            collectEdges(mesh, chunks[c], c, edges);
            const std::uint32_t count =
                numberEdges(edges, std::span(result.cornerVertex).subspan(result.firstCorner[c], edges.size()), slots);
            unique.edges[c].assign(edges.begin(), edges.begin() + count);
        }
    });
    unique.first.push_back(0);
    for (const auto& edges : unique.edges)
        unique.first.push_back(unique.first.back() + edges.size());
    return unique;
}

/// The chunks' edges, dealt to the parts; inside a part in the order of the chunks.
struct DealtEdges {
    std::array<std::uint64_t, partCount + 1> firstOfPart{};
    Buffer<Edge> edges;
    Buffer<std::uint32_t> indices; ///< among the chunks' edges
};

using PartCounts = std::array<std::uint64_t, partCount>;

/// Turns counts per chunk and part into the places where each chunk's edges of each part begin.
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

DealtEdges deal(const ChunkEdges& unique)
{
    const tbb::blocked_range<std::size_t> allChunks(0, unique.edges.size());
    std::vector<PartCounts> places(unique.edges.size(), PartCounts{});
    tbb::parallel_for(allChunks, [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c)
            for (const Edge& edge : unique.edges[c])
                ++places[c][partOf(hashOf(edge))];
    });
    DealtEdges dealt;
    dealt.firstOfPart = placesFromCounts(places);
    dealt.edges.resize(unique.first.back());
    dealt.indices.resize(unique.first.back());
    tbb::parallel_for(allChunks, [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c) {
            auto index = static_cast<std::uint32_t>(unique.first[c]);
            for (const Edge& edge : unique.edges[c]) {
                const std::uint64_t place = places[c][partOf(hashOf(edge))]++;
                dealt.edges[place] = edge;
                dealt.indices[place] = index++;
            }
        }
    });
    return dealt;
}

/// Numbers the dealt edges and keeps the different ones as the vertices' edges; returns the vertex of each of the
/// chunks' edges.
Buffer<std::uint32_t> numberAcrossChunks(DealtEdges dealt, EdgeVertices& result)
{
    const auto partOfBuffer = [&](auto& buffer, std::size_t part) {
        return std::span(buffer).subspan(dealt.firstOfPart[part],
                                         dealt.firstOfPart[part + 1] - dealt.firstOfPart[part]);
    };
    const tbb::blocked_range<std::size_t> allParts(0, partCount, 1);
    Buffer<std::uint32_t> numbers(dealt.edges.size());
    std::array<std::uint32_t, partCount + 1> firstVertex{};
    tbb::parallel_for(allParts, [&](const auto& range) {
        std::vector<std::uint32_t> slots;
        for (std::size_t part = range.begin(); part != range.end(); ++part)
            firstVertex[part + 1] = numberEdges(partOfBuffer(dealt.edges, part), partOfBuffer(numbers, part), slots);
    });
    for (std::size_t part = 0; part < partCount; ++part)
        firstVertex[part + 1] += firstVertex[part];

    result.edges.resize(firstVertex[partCount]);
    Buffer<std::uint32_t> vertices(dealt.edges.size());
    tbb::parallel_for(allParts, [&](const auto& range) {
        for (std::size_t part = range.begin(); part != range.end(); ++part) {
            std::copy_n(partOfBuffer(dealt.edges, part).begin(), firstVertex[part + 1] - firstVertex[part],
                        result.edges.begin() + firstVertex[part]);
            const auto indices = partOfBuffer(dealt.indices, part);
            const auto local = partOfBuffer(numbers, part);
            for (std::size_t i = 0; i < indices.size(); ++i)
                vertices[indices[i]] = firstVertex[part] + local[i];
        }
    });
    return vertices;
}

} // namespace

EdgeVertices numberEdgeVertices(const TetrahedralMesh& mesh, std::span<const CrossedChunk> chunks)
{
    EdgeVertices result;
    result.firstCorner.push_back(0);
    for (const CrossedChunk& chunk : chunks)
        result.firstCorner.push_back(result.firstCorner.back() + chunk.corners);
    result.cornerVertex.resize(result.firstCorner.back());

    const ChunkEdges unique = numberInsideChunks(mesh, chunks, result);
    const Buffer<std::uint32_t> vertices = numberAcrossChunks(deal(unique), result);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t c) {
        for (std::uint64_t corner = result.firstCorner[c]; corner < result.firstCorner[c + 1]; ++corner)
            result.cornerVertex[corner] = vertices[unique.first[c] + result.cornerVertex[corner]];
    });
    return result;
}

} // namespace tetra
