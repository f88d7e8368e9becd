// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/isosurface/surface_chunks.h"

#include "core/base/flat_index.h"
#include "core/base/simd.h"
#include "core/mesh/topology.h"
#include "core/render/isosurface/crossed_tetrahedra.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace tetra {

namespace {

using EdgeIndex = FlatIndex<EdgeKey>;

/// An EdgeIndex gets room for so many times the edges that come: then most of them are found at once.
constexpr std::size_t edgeSparseness = 4;

/// Crossed tetrahedra that are marched through step by step together: what lies between the steps stays in the nearest
/// cache.
constexpr std::size_t marchedTogether = 64;

/// Two triangles always, of which the second counts if the piece has four corners.
Triangle* writeTriangles(std::span<const CrossedTetrahedron> crossed, const std::uint32_t* corners, Triangle* triangles)
{
    for (const CrossedTetrahedron one : crossed) {
        const int count = marchingCases[one % 16].corners;
        triangles[0] = {corners[0], corners[1], corners[2]};
        triangles[1] = {corners[0], corners[2], corners[3]};
        corners += count;
        triangles += count - 2;
    }
    return triangles;
}

/// What a thread keeps from run to run.
class Marcher {
public:
    Marcher(const TetrahedralMesh& mesh, const VertexSigns& sides)
        : mesh_(mesh), sides_(sides), crossed_(surfaceChunkSize + crossedTetrahedronRoom)
    {
    }

    /// Makes the surface in the chunks from `first` on that `isCrossed` tells.
    template <class IsCrossed> SurfaceChunk march(std::size_t first, std::size_t end, IsCrossed&& isCrossed)
    {
        const std::span run = std::span(mesh_.tetrahedra).subspan(first, end - first);
        const std::span crossed = findCrossedIn(run, first / rangedChunkSize, isCrossed);
        edges_.clear(edgeSparseness * crossed.size() * 3 / 4);
        Buffer<Triangle> triangles(2 * crossed.size());
        Triangle* next = triangles.data();
        for (std::size_t i = 0; i < crossed.size(); i += marchedTogether)
            next = marchSome(run, crossed.subspan(i, std::min(marchedTogether, crossed.size() - i)), next);
        triangles.resize(static_cast<std::size_t>(next - triangles.data()));
        return {{edges_.keys().begin(), edges_.keys().end()}, std::move(triangles)};
    }

private:
    /// Chunks that are passed over stop the processor from fetching ahead itself.
    static constexpr std::size_t chunksAhead = 4;

    /// Lists the chunks to look at first, so that what is fetched is one of them.
    template <class IsCrossed> std::span<const CrossedTetrahedron>
    findCrossedIn(std::span<const Tetrahedron> run, std::size_t firstChunk, IsCrossed&& isCrossed)
    {
        const std::size_t chunkCount = (run.size() + rangedChunkSize - 1) / rangedChunkSize;
        std::array<std::uint32_t, surfaceChunkSize / rangedChunkSize + chunksAhead> chunks; // their first tetrahedra
        std::size_t count = 0;
        for (std::size_t chunk = 0; chunk < chunkCount; ++chunk) {
            chunks[count] = static_cast<std::uint32_t>(chunk * rangedChunkSize);
            count += isCrossed(firstChunk + chunk) ? 1 : 0;
        }
        std::fill_n(chunks.begin() + static_cast<std::ptrdiff_t>(count), chunksAhead, 0u);
        CrossedTetrahedron* last = crossed_.data();
        for (std::size_t i = 0; i < count; ++i) {
            const Tetrahedron* next = run.data() + chunks[i + chunksAhead];
            for (std::size_t t = 0; t < rangedChunkSize; t += 4)
                __builtin_prefetch(next + t);
            last = findCrossed(run.subspan(chunks[i], std::min(rangedChunkSize, run.size() - chunks[i])), chunks[i],
                               sides_, last);
        }
        return {crossed_.data(), last};
    }

    Triangle* marchSome(std::span<const Tetrahedron> run, std::span<const CrossedTetrahedron> crossed,
                        Triangle* triangles)
    {
        std::array<EdgeKey, 4 * marchedTogether> edges;
        std::array<std::uint32_t, 4 * marchedTogether> numbers;
        const auto count = static_cast<std::size_t>(writeCrossedEdges(run, crossed, edges.data()) - edges.data());
        edges_.numberAll({edges.data(), count}, [&](std::size_t i, std::uint32_t number) { numbers[i] = number; });
        return writeTriangles(crossed, numbers.data(), triangles);
    }

    const TetrahedralMesh& mesh_;
    const VertexSigns& sides_;
    Buffer<CrossedTetrahedron> crossed_;
    EdgeIndex edges_;
};

} // namespace

std::vector<SurfaceChunk> makeSurfaceChunks(const TetrahedralMesh& mesh, std::span<const float> values,
                                            const IsosurfaceIndex* index, double isovalue, const Progress& progress)
{
    const VertexSigns sides(values, isovalue);
    const std::size_t total = mesh.tetrahedra.size();
    std::vector<SurfaceChunk> runs((total + surfaceChunkSize - 1) / surfaceChunkSize);
    tbb::enumerable_thread_specific<Marcher> marchers([&] { return Marcher(mesh, sides); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, runs.size(), 1), [&](const auto& range) {
        Marcher& marcher = marchers.local();
        for (std::size_t run = range.begin(); run != range.end() && !progress.cancelled(); ++run)
            runs[run] = marcher.march(
                run * surfaceChunkSize, std::min(total, (run + 1) * surfaceChunkSize),
                [&](std::size_t chunk) { return index == nullptr || index->ranges[chunk].crossedAt(isovalue); });
    });
    return runs;
}

namespace {

/// Enough to keep each part's hash table in the cache and many threads busy.
constexpr std::size_t partCount = 32;
constexpr int partBits = std::countr_zero(partCount);

/// For each vertex that is the smaller end of some of the runs' edges, the only run that has these, or `several`; what
/// other vertices have is undefined.
Buffer<std::uint32_t> findOwners(std::span<const SurfaceChunk> runs, std::size_t vertexCount)
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
struct BinnedEdges {
    std::size_t owned = 0;
    std::array<std::size_t, partCount + 1> firstOfPart{};
    Buffer<std::uint32_t> indices; ///< of each edge among all runs' edges
};

/// Turns the counts of each run into its places.
BinnedEdges placesFromCounts(std::vector<Places>& places)
{
    BinnedEdges dealt;
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
template <class IsOwn> BinnedEdges deal(std::span<const SurfaceChunk> runs, IsOwn&& isOwn, SurfaceVertices& result)
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
    BinnedEdges dealt = placesFromCounts(places);
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
void numberParts(const BinnedEdges& dealt, SurfaceVertices& result)
{
    const tbb::blocked_range<std::size_t> allParts(0, partCount, 1);
    std::array<std::vector<EdgeKey>, partCount> unique;
    tbb::parallel_for(allParts, [&](const auto& range) {
        EdgeIndex index;
        for (std::size_t part = range.begin(); part != range.end(); ++part) {
            const std::size_t first = dealt.firstOfPart[part], count = dealt.firstOfPart[part + 1] - first;
            index.clear(edgeSparseness * count);
            index.numberAll({result.edges.data() + first, count}, [&](std::size_t i, std::uint32_t number) {
                result.numbers[dealt.indices[first + i]] = number;
            });
            unique[part].assign(index.keys().begin(), index.keys().end());
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

SurfaceVertices numberVertices(std::span<const SurfaceChunk> runs, const IsosurfaceIndex* index,
                               std::size_t vertexCount)
{
    SurfaceVertices result;
    result.firstOfRun.push_back(0);
    for (const SurfaceChunk& run : runs)
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

namespace {

constexpr std::size_t edgesFetchedAhead = 24;
constexpr std::size_t blockSize = 64;

template <class Number> using Components = std::array<std::array<Number, blockSize>, 3>;

/// The edges of some vertices, and what becomes of them, component by component. Edges are walked inwards: whatever the
/// numbers of their ends are, the vertex is at the same place to the last bit.
struct VertexBlock {
    std::array<std::array<std::uint32_t, 2>, blockSize> ends; ///< the one outside first
    std::array<std::array<float, blockSize>, 2> values;
    std::array<Components<double>, 2> positions;
    std::array<Components<float>, 2> gradients;
    Components<double> placed;
    Components<float> normals;
    std::array<std::uint8_t, blockSize> findings; ///< bit 0, 1: it lies in the first, second end; bit 2: no normal
};

void load(const TetrahedralMesh& mesh, std::span<const float> values, std::span<const Eigen::Vector3f> gradients,
          std::span<const EdgeKey> edges, double isovalue, std::size_t first, std::size_t count, VertexBlock& block)
{
    for (std::size_t i = 0; i < count; ++i) {
        for (const std::uint32_t end : endsOf(edges[std::min(first + i + edgesFetchedAhead, edges.size() - 1)])) {
            __builtin_prefetch(&mesh.positions[end]);
            __builtin_prefetch(&values[end]);
            __builtin_prefetch(&gradients[end]);
        }
        const auto [a, b] = endsOf(edges[first + i]);
        // Which end is inside is hard to predict, so that decides no branch.
        const std::uint32_t isFirstInside = static_cast<double>(values[a]) >= isovalue ? 1 : 0;
        const std::uint32_t swap = (a ^ b) & (0 - isFirstInside);
        const std::array ends = {a ^ swap, b ^ swap};
        block.ends[i] = ends;
        for (std::size_t end = 0; end < 2; ++end) {
            block.values[end][i] = values[ends[end]];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block.positions[end][axis][i] = mesh.positions[ends[end]][static_cast<int>(axis)];
                block.gradients[end][axis][i] = gradients[ends[end]][static_cast<int>(axis)];
            }
        }
    }
}

/// An end that the vertex coincides with counts alone: the other's gradient may not be finite. Squares of floats
/// neither vanish nor overflow in doubles.
TETRA_SIMD_INLINE void computeVertices(VertexBlock& block, double isovalue)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < blockSize; ++i) {
        const double fraction = crossingShare(isovalue, double(block.values[0][i]), double(block.values[1][i]));
        unsigned notFirst = 0, notSecond = 0;
        double square = 0;
        double directions[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double from = block.positions[0][axis][i], to = block.positions[1][axis][i];
            const double place = coordinateAt(from, to, fraction);
            block.placed[axis][i] = place;
            notFirst |= place != from ? 1u : 0u;
            notSecond |= place != to ? 1u : 0u;
            const double first = double(block.gradients[0][axis][i]), second = double(block.gradients[1][axis][i]);
            const double mean = (1 - fraction) * first + fraction * second;
            directions[axis] = fraction <= 0 ? first : fraction >= 1 ? second : mean;
            square += directions[axis] * directions[axis];
        }
        const bool known = square > 0 && square < infinity;
        const double scale = -1 / std::sqrt(known ? square : 1.0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            block.normals[axis][i] = known ? static_cast<float>(directions[axis] * scale) : 0.0f;
        block.findings[i] = static_cast<std::uint8_t>((notFirst ^ 1u) | (notSecond ^ 1u) << 1 | (known ? 0u : 4u));
    }
}

void storeBlock(const VertexBlock& block, std::size_t first, std::size_t count, TriangleMesh& surface,
                PlacingFindings& found)
{
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t vertex = first + i;
        surface.positions[vertex] = {block.placed[0][i], block.placed[1][i], block.placed[2][i]};
        surface.normals[vertex] = {block.normals[0][i], block.normals[1][i], block.normals[2][i]};
        const unsigned findings = block.findings[i];
        if (findings == 0)
            continue;
        found.normalsMissing = found.normalsMissing || (findings & 4) != 0;
        if ((findings & 3) != 0)
            found.ties.push_back({block.ends[i][(findings & 1) != 0 ? 0 : 1], static_cast<std::uint32_t>(vertex)});
    }
}

} // namespace

PlacingFindings placeVertices(const TetrahedralMesh& mesh, std::span<const float> values,
                              std::span<const Eigen::Vector3f> gradients, std::span<const EdgeKey> edges,
                              double isovalue, TriangleMesh& surface)
{
    surface.positions.resize(edges.size());
    surface.normals.resize(edges.size());
    tbb::enumerable_thread_specific<PlacingFindings> found;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), 1 << 10), [&](const auto& range) {
        PlacingFindings& mine = found.local();
        VertexBlock block{};
        for (std::size_t first = range.begin(); first < range.end(); first += blockSize) {
            const std::size_t count = std::min(blockSize, range.end() - first);
            load(mesh, values, gradients, edges, isovalue, first, count, block);
            dispatch<computeVertices>(block, isovalue);
            storeBlock(block, first, count, surface, mine);
        }
    });
    PlacingFindings all;
    for (const PlacingFindings& one : found) {
        all.ties.insert(all.ties.end(), one.ties.begin(), one.ties.end());
        all.normalsMissing = all.normalsMissing || one.normalsMissing;
    }
    std::ranges::sort(all.ties);
    return all;
}

namespace {

constexpr std::size_t tiesAtOnce = 1 << 13;
constexpr std::uint32_t welded = 0xffffffff;

/// The new number of each vertex; those that are welded get the number of the first of their place. Their positions,
/// normals and edges go.
Buffer<std::uint32_t> renumberVertices(std::span<const CoincidentVertex> ties, TriangleMesh& surface,
                                       Buffer<EdgeKey>& edges)
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
        edges[next] = edges[v];
        numbers[v] = next++;
    }
    surface.positions.resize(next);
    surface.normals.resize(next);
    edges.resize(next);
    for (std::size_t i = 1; i < ties.size(); ++i)
        if (ties[i].meshVertex == ties[i - 1].meshVertex)
            numbers[ties[i].vertex] = numbers[ties[i - 1].vertex]; // the first of a place has the smallest number
    return numbers;
}

} // namespace

void weldAtMeshVertices(std::span<const CoincidentVertex> ties, TriangleMesh& surface, Buffer<EdgeKey>& edges,
                        Buffer<std::uint32_t>* cells)
{
    const Buffer<std::uint32_t> numbers = renumberVertices(ties, surface, edges);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.triangles.size(), tiesAtOnce), [&](const auto& range) {
        for (std::size_t t = range.begin(); t != range.end(); ++t)
            for (std::uint32_t& corner : surface.triangles[t])
                corner = numbers[corner];
    });
    const auto isFlat = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
    if (cells != nullptr) {
        std::size_t left = 0;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            if (!isFlat(surface.triangles[t]))
                (*cells)[left++] = (*cells)[t];
        cells->resize(left);
    }
    std::erase_if(surface.triangles, isFlat);
}

} // namespace tetra
