// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/surface_vertices.h"

#include "core/graphics/edge_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace tetra {
namespace {

/// Enough to keep each part's hash table in the cache and many threads busy. After them, what belongs to one run.
constexpr std::size_t partCount = 32;
constexpr int partBits = std::countr_zero(partCount);

/// How many edges of a run are its own, and how many each part gets; later where the next one goes.
using Places = std::array<std::size_t, partCount + 1>;

std::size_t partOf(EdgeKey edge, const IsosurfaceIndex* index) noexcept
{
    if (index != nullptr) {
        const auto [a, b] = endsOf(edge);
        if ((index->inOneRun[a] | index->inOneRun[b]) != 0)
            return partCount;
    }
    return (edge ^ edge >> 29) * 0xbf58476d1ce4e5b9u >> (64 - partBits);
}

/// Edges that several runs may have, dealt to the parts; inside a part in the order of the runs.
struct DealtEdges {
    std::array<std::size_t, partCount + 1> firstOfPart{};
    Buffer<EdgeKey> edges;
    Buffer<std::uint32_t> indices; ///< among all runs' edges
};

/// Numbers the runs' own edges and deals the others.
DealtEdges deal(std::span<const SurfaceRun> runs, const IsosurfaceIndex* index, SurfaceVertices& result,
                std::size_t& owned)
{
    std::vector<Places> places(runs.size(), Places{});
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
        for (const EdgeKey edge : runs[run].edges)
            ++places[run][partOf(edge, index)];
    });
    DealtEdges dealt;
    std::size_t place = 0;
    for (std::size_t part = 0; part < partCount; ++part) {
        dealt.firstOfPart[part] = place;
        for (Places& ofRun : places)
            place += std::exchange(ofRun[part], place);
    }
    dealt.firstOfPart[partCount] = place;
    owned = 0;
    for (Places& ofRun : places)
        owned += std::exchange(ofRun[partCount], owned);

    dealt.edges.resize(place);
    dealt.indices.resize(place);
    result.edges.resize(owned + place);
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
        std::size_t number = result.firstOfRun[run];
        for (const EdgeKey edge : runs[run].edges) {
            const std::size_t part = partOf(edge, index);
            const std::size_t to = places[run][part]++;
            if (part == partCount) {
                result.edges[to] = edge;
                result.numbers[number] = static_cast<std::uint32_t>(to);
            } else {
                dealt.edges[to] = edge;
                dealt.indices[to] = static_cast<std::uint32_t>(number);
            }
            ++number;
        }
    });
    return dealt;
}

/// Numbers the dealt edges from `owned` on.
void numberDealt(const DealtEdges& dealt, std::size_t owned, SurfaceVertices& result)
{
    const tbb::blocked_range<std::size_t> allParts(0, partCount, 1);
    std::array<std::vector<EdgeKey>, partCount> unique;
    tbb::parallel_for(allParts, [&](const auto& range) {
        EdgeTable table;
        for (std::size_t part = range.begin(); part != range.end(); ++part) {
            table.clear();
            auto numbering = table.begin(dealt.firstOfPart[part + 1] - dealt.firstOfPart[part]);
            for (std::size_t i = dealt.firstOfPart[part]; i < dealt.firstOfPart[part + 1]; ++i)
                result.numbers[dealt.indices[i]] = numbering.numberOf(dealt.edges[i]);
            table.end(numbering);
            unique[part].assign(table.keys().begin(), table.keys().end());
        }
    });
    std::array<std::size_t, partCount + 1> first{owned};
    for (std::size_t part = 0; part < partCount; ++part)
        first[part + 1] = first[part] + unique[part].size();
    result.edges.resize(first[partCount]);
    tbb::parallel_for(allParts, [&](const auto& range) {
        for (std::size_t part = range.begin(); part != range.end(); ++part) {
            std::ranges::copy(unique[part], result.edges.begin() + static_cast<std::ptrdiff_t>(first[part]));
            for (std::size_t i = dealt.firstOfPart[part]; i < dealt.firstOfPart[part + 1]; ++i)
                result.numbers[dealt.indices[i]] += static_cast<std::uint32_t>(first[part]);
        }
    });
}

} // namespace

SurfaceVertices numberVertices(std::span<const SurfaceRun> runs, const IsosurfaceIndex* index)
{
    SurfaceVertices result;
    result.firstOfRun.push_back(0);
    for (const SurfaceRun& run : runs)
        result.firstOfRun.push_back(result.firstOfRun.back() + run.edges.size());
    result.numbers.resize(result.firstOfRun.back());
    std::size_t owned = 0;
    const DealtEdges dealt = deal(runs, index, result, owned);
    numberDealt(dealt, owned, result);
    return result;
}

} // namespace tetra
