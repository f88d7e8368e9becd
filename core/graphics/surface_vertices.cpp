// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/surface_vertices.h"

#include "core/graphics/edge_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

namespace tetra {
namespace {

/// Enough to keep each part's hash table in the cache and many threads busy.
constexpr std::size_t partCount = 32;
constexpr int partBits = std::countr_zero(partCount);

/// For each vertex that is the smaller end of some of the runs' edges, the only run that has these, or `several`; what
/// other vertices have is undefined.
Buffer<std::uint32_t> findOwners(std::span<const SurfaceRun> runs, std::size_t vertexCount)
{
    constexpr std::uint32_t several = 0xffffffff;
    Buffer<std::uint32_t> owners(vertexCount);
    const auto forEachEdge = [&](auto&& visit) {
        tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
            for (const EdgeKey edge : runs[run].edges)
                visit(std::atomic_ref(owners[endsOf(edge)[0]]), static_cast<std::uint32_t>(run));
        });
    };
    // Whichever run of several comes last, another one sees that it is not alone.
    forEachEdge([](auto owner, std::uint32_t run) { owner.store(run, std::memory_order_relaxed); });
    forEachEdge([](auto owner, std::uint32_t run) {
        if (owner.load(std::memory_order_relaxed) != run)
            owner.store(several, std::memory_order_relaxed);
    });
    return owners;
}

std::size_t tablePartOf(EdgeKey edge) noexcept
{
    return (edge ^ edge >> 29) * 0xbf58476d1ce4e5b9u >> (64 - partBits);
}

/// How many of a run's edges are its own, and how many of the others each part gets; later where the next one goes.
struct Places {
    std::size_t own = 0;
    std::array<std::size_t, partCount> parts{};

    /// The place of an edge, and then the next one. Whether it is the run's own is hard to predict, so that decides no
    /// branch.
    std::size_t take(EdgeKey edge, bool isOwn) noexcept
    {
        std::size_t& part = parts[tablePartOf(edge)];
        const std::size_t place = isOwn ? own : part;
        own += isOwn ? 1 : 0;
        part += isOwn ? 0 : 1;
        return place;
    }
};

/// Where the edges went: first all that are their run's own, then those of each part, inside a part in the order of the
/// runs.
struct DealtEdges {
    std::size_t owned = 0;
    std::array<std::size_t, partCount + 1> firstOfPart{};
    Buffer<std::uint32_t> indices; ///< of each edge among all runs' edges
};

/// Turns the counts of each run into its places.
DealtEdges placesFromCounts(std::vector<Places>& places)
{
    DealtEdges dealt;
    for (Places& ofRun : places)
        dealt.owned += std::exchange(ofRun.own, dealt.owned);
    std::size_t place = dealt.owned;
    for (std::size_t part = 0; part < partCount; ++part) {
        dealt.firstOfPart[part] = place;
        for (Places& ofRun : places)
            place += std::exchange(ofRun.parts[part], place);
    }
    dealt.firstOfPart[partCount] = place;
    return dealt;
}

/// Deals the edges and numbers them by their places, for the runs' own ones for good. isOwn(edge, run) tells these.
template <class IsOwn> DealtEdges deal(std::span<const SurfaceRun> runs, IsOwn&& isOwn, SurfaceVertices& result)
{
    std::vector<Places> places(runs.size());
    const auto forEachPlace = [&](auto&& visit) {
        tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
            Places next = places[run];
            std::size_t index = result.firstOfRun[run];
            for (const EdgeKey edge : runs[run].edges)
                visit(edge, index++, next.take(edge, isOwn(edge, run)));
            places[run] = next;
        });
    };
    forEachPlace([](EdgeKey, std::size_t, std::size_t) {});
    DealtEdges dealt = placesFromCounts(places);
    const std::size_t total = dealt.firstOfPart[partCount];
    dealt.indices.resize(total);
    result.edges.resize(total);
    result.numbers.resize(total);
    forEachPlace([&](EdgeKey edge, std::size_t index, std::size_t place) {
        result.edges[place] = edge;
        result.numbers[index] = static_cast<std::uint32_t>(place);
        dealt.indices[place] = static_cast<std::uint32_t>(index);
    });
    return dealt;
}

/// Numbers the edges of the parts again, the same ones alike.
void numberParts(const DealtEdges& dealt, SurfaceVertices& result)
{
    const tbb::blocked_range<std::size_t> allParts(0, partCount, 1);
    std::array<std::vector<EdgeKey>, partCount> unique;
    tbb::parallel_for(allParts, [&](const auto& range) {
        EdgeTable table;
        for (std::size_t part = range.begin(); part != range.end(); ++part) {
            const std::size_t count = dealt.firstOfPart[part + 1] - dealt.firstOfPart[part];
            table.clear(count);
            auto numbering = table.begin(count);
            for (std::size_t i = dealt.firstOfPart[part]; i < dealt.firstOfPart[part + 1]; ++i)
                result.numbers[dealt.indices[i]] = numbering.numberOf(result.edges[i]);
            table.end(numbering);
            unique[part].assign(table.keys().begin(), table.keys().end());
        }
    });
    std::array<std::size_t, partCount + 1> first{dealt.owned};
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

SurfaceVertices numberVertices(std::span<const SurfaceRun> runs, const IsosurfaceIndex* index, std::size_t vertexCount)
{
    SurfaceVertices result;
    result.firstOfRun.push_back(0);
    for (const SurfaceRun& run : runs)
        result.firstOfRun.push_back(result.firstOfRun.back() + run.edges.size());
    const auto dealBy = [&](auto&& isOwn) { numberParts(deal(runs, isOwn, result), result); };
    if (index != nullptr) {
        dealBy([&](EdgeKey edge, std::size_t) {
            const auto [a, b] = endsOf(edge);
            return (index->inOneRun[a] | index->inOneRun[b]) != 0;
        });
    } else {
        const Buffer<std::uint32_t> owners = findOwners(runs, vertexCount);
        dealBy([&](EdgeKey edge, std::size_t run) { return owners[endsOf(edge)[0]] == run; });
    }
    return result;
}

} // namespace tetra
