// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/isosurface/isosurface.h"

#include "core/base/flat_index.h"
#include "core/base/guarded.h"
#include "core/base/simd.h"
#include "core/mesh/topology.h"
#include "core/render/isosurface/surface_chunks.h"

#include <tan/render.h>

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

namespace {

/// Calls visit(vertex, run) for each corner, on all threads.
template <class Visit> void forEachCorner(const TetrahedralMesh& mesh, Visit&& visit)
{
    const std::size_t count = mesh.tetrahedra.size();
    tbb::parallel_for(std::size_t(0), (count + surfaceChunkSize - 1) / surfaceChunkSize, [&](std::size_t run) {
        for (std::size_t t = run * surfaceChunkSize; t < std::min(count, (run + 1) * surfaceChunkSize); ++t)
            for (const std::uint32_t vertex : mesh.tetrahedra[t])
                visit(vertex, static_cast<std::uint32_t>(run));
    });
}

} // namespace

IsosurfaceIndex makeIsosurfaceIndex(const TetrahedralMesh& mesh)
{
    IsosurfaceIndex index;
    index.ranges = chunkRanges(mesh);
    // Whichever run of several comes last, another one sees that it is not alone.
    Buffer<std::uint32_t> runs(mesh.positions.size());
    index.inOneRun.assign(mesh.positions.size(), 1);
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t run) {
        std::atomic_ref(runs[vertex]).store(run, std::memory_order_relaxed);
    });
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t run) {
        if (std::atomic_ref(runs[vertex]).load(std::memory_order_relaxed) != run)
            std::atomic_ref(index.inOneRun[vertex]).store(0, std::memory_order_relaxed);
    });
    return index;
}

namespace {

constexpr MarkedText extractingIsosurface = Message::marked("Extracting the isosurface");

TETRA_SIMD_INLINE void renumberTriangles(const Triangle* triangles, std::size_t count, const std::uint32_t* numbers,
                                         Triangle* renumbered)
{
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            renumbered[i][corner] = numbers[triangles[i][corner]];
}

Buffer<Triangle> joinTriangles(std::span<const SurfaceChunk> runs, const SurfaceVertices& vertices)
{
    std::vector<std::size_t> first(1, 0);
    for (const SurfaceChunk& run : runs)
        first.push_back(first.back() + run.triangles.size());
    Buffer<Triangle> triangles(first.back());
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
        dispatch<renumberTriangles>(runs[run].triangles.data(), runs[run].triangles.size(),
                                    vertices.numbers.data() + vertices.firstOfRun[run], triangles.data() + first[run]);
    });
    return triangles;
}

/// The tetrahedron of each triangle, in the order of joinTriangles(): a corner that is cut off gives one, two and two
/// that are parted give two.
Buffer<std::uint32_t> cellsOfTriangles(const TetrahedralMesh& mesh, std::span<const float> values, double isovalue)
{
    Buffer<std::uint32_t> cells;
    for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const auto inside = std::ranges::count_if(
            mesh.tetrahedra[t], [&](std::uint32_t vertex) { return static_cast<double>(values[vertex]) >= isovalue; });
        for (auto triangle = std::min(inside, 4 - inside); triangle > 0; --triangle)
            cells.push_back(t);
    }
    return cells;
}

Status checkArguments(const TetrahedralMesh& mesh, const IsosurfaceIndex* index,
                      std::span<const Eigen::Vector3f> gradients, double isovalue)
{
    if (std::isnan(isovalue))
        return Error{ErrorKind::WrongUsage, Message::say("The isovalue is not a number.")};
    const std::size_t vertices = mesh.positions.size();
    const std::size_t chunks = (mesh.tetrahedra.size() + rangedChunkSize - 1) / rangedChunkSize;
    if (mesh.values.size() != vertices || gradients.size() != vertices ||
        (index != nullptr && (index->inOneRun.size() != vertices || index->ranges.size() != chunks)))
        return Error{ErrorKind::WrongUsage,
                     Message::say("The mesh, its values, its gradients and its index do not belong together.")};
    return {};
}

} // namespace

Result<Contour> extractContour(const TetrahedralMesh& mesh, std::span<const float> values, const IsosurfaceIndex* index,
                               std::span<const Eigen::Vector3f> gradients, double isovalue, const Progress& progress,
                               Buffer<std::uint32_t>* cells)
{
    progress.report(0, extractingIsosurface);
    const std::vector<SurfaceChunk> runs = makeSurfaceChunks(mesh, values, index, isovalue, progress);
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    std::uint64_t edges = 0;
    for (const SurfaceChunk& run : runs)
        edges += run.edges.size();
    if (edges > largestRunEdgeCount)
        return Error{
            ErrorKind::OutOfResource,
            Message::say("The isosurface has more than four billion vertices. Lower the accuracy of the mesh.")};

    progress.report(0.6, extractingIsosurface);
    SurfaceVertices vertices = numberVertices(runs, index, mesh.positions.size());
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    progress.report(0.7, extractingIsosurface);
    TriangleMesh surface;
    const PlacingFindings found = placeVertices(mesh, values, gradients, vertices.edges, isovalue, surface);
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    progress.report(0.9, extractingIsosurface);
    surface.triangles = joinTriangles(runs, vertices);
    if (cells != nullptr)
        *cells = cellsOfTriangles(mesh, values, isovalue);
    if (!found.ties.empty())
        weldAtMeshVertices(found.ties, surface, vertices.edges, cells);
    if (found.normalsMissing)
        fillNormalsFromTriangles(surface);
    progress.report(1, extractingIsosurface);
    return Contour{std::move(surface), std::move(vertices.edges)};
}

namespace {

Result<TriangleMesh> extractChecked(const TetrahedralMesh& mesh, const IsosurfaceIndex* index,
                                    std::span<const Eigen::Vector3f> gradients, double isovalue,
                                    const Progress& progress, Buffer<std::uint32_t>* cells = nullptr)
{
    if (Status status = checkArguments(mesh, index, gradients, isovalue); !status)
        return status.error();
    return guarded(Message::marked(
                       "Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh."),
                   [&]() -> Result<TriangleMesh> {
                       auto contour = extractContour(mesh, mesh.values, index, gradients, isovalue, progress, cells);
                       if (!contour)
                           return contour.error();
                       return std::move(contour->surface);
                   });
}

} // namespace

Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                                       double isovalue, const Progress& progress, Buffer<std::uint32_t>* cells)
{
    return extractChecked(mesh, nullptr, gradients, isovalue, progress, cells);
}

Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, const IsosurfaceIndex& index,
                                       std::span<const Eigen::Vector3f> gradients, double isovalue,
                                       const Progress& progress)
{
    return extractChecked(mesh, &index, gradients, isovalue, progress);
}

namespace {

/// The unit vector of a direction, or zero if it has none. Scaled first, so that no square overflows or vanishes.
Eigen::Vector3f unitOrZero(const Eigen::Vector3d& direction)
{
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !direction.allFinite())
        return Eigen::Vector3f::Zero();
    return (direction / largest).normalized().cast<float>();
}

} // namespace

void fillNormalsFromTriangles(TriangleMesh& surface)
{
    FlatIndex<std::uint32_t> wanting;
    for (std::size_t v = 0; v < surface.normals.size(); ++v)
        if (surface.normals[v].isZero(0))
            wanting.numberOf(static_cast<std::uint32_t>(v));
    std::vector<Eigen::Vector3d> sums(wanting.size(), Eigen::Vector3d::Zero());
    for (const auto& triangle : surface.triangles) {
        const Eigen::Vector3d& corner = surface.positions[triangle[0]];
        const Eigen::Vector3d normal =
            (surface.positions[triangle[1]] - corner).cross(surface.positions[triangle[2]] - corner);
        for (const std::uint32_t vertex : triangle)
            if (const std::uint32_t number = wanting.find(vertex); number != FlatIndex<std::uint32_t>::none)
                sums[number] += normal;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Eigen::Vector3f normal = unitOrZero(sums[i]);
        surface.normals[wanting.keys()[i]] = normal.isZero(0) ? Eigen::Vector3f::UnitZ() : normal;
    }
}

namespace {

/// Sums over the tetrahedra of a vertex: six times volume times gradient, and six times volume.
struct GradientSum {
    Eigen::Vector3f gradient{0, 0, 0};
    float volume = 0;

    void add(const GradientSum& term)
    {
        gradient += term.gradient;
        volume += term.volume;
    }
};

/// Position and value of a vertex, side by side: in a mesh in order of construction each corner is a cache miss, and
/// so it is one instead of two.
struct Corner {
    Eigen::Vector3d position;
    double value;
};

using Tetrahedra = std::span<const std::array<std::uint32_t, 4>>;

Buffer<Corner> makeCorners(const TetrahedralMesh& mesh)
{
    Buffer<Corner> corners(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, corners.size(), 1 << 15), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            corners[v] = {mesh.positions[v], static_cast<double>(mesh.values[v])};
    });
    return corners;
}

GradientSum termOf(const Corner& first, const Corner& second, const Corner& third, const Corner& fourth)
{
    const Eigen::Vector3d& origin = first.position;
    const Eigen::Vector3d b = second.position - origin;
    const Eigen::Vector3d c = third.position - origin;
    const Eigen::Vector3d d = fourth.position - origin;
    const double value = first.value;
    const Eigen::Vector3d normal = c.cross(d);
    const Eigen::Vector3d gradient =
        (second.value - value) * normal + (third.value - value) * d.cross(b) + (fourth.value - value) * b.cross(c);
    const GradientSum term{gradient.cast<float>(), static_cast<float>(b.dot(normal))};
    // A corner without a number would take the gradients of all corners with it.
    return std::isfinite(term.gradient.sum() + term.volume) ? term : GradientSum();
}

/// Calls visit(term, tetrahedron) for each, having asked for its corners, and for what prefetch(vertex) asks, some
/// turns before.
template <class Prefetch, class Visit>
void forEachTerm(Tetrahedra tetrahedra, const Buffer<Corner>& corners, Prefetch&& prefetch, Visit&& visit)
{
    constexpr std::size_t ahead = 12;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
        if (t + ahead < tetrahedra.size())
            for (const std::uint32_t vertex : tetrahedra[t + ahead]) {
                __builtin_prefetch(&corners[vertex]);
                prefetch(vertex);
            }
        const auto& sites = tetrahedra[t];
        visit(termOf(corners[sites[0]], corners[sites[1]], corners[sites[2]], corners[sites[3]]), t);
    }
}

/// On one thread, in the order of the tetrahedra.
void addUp(Tetrahedra tetrahedra, const Buffer<Corner>& corners, std::span<GradientSum> sums)
{
    const auto prefetch = [&](std::uint32_t vertex) { __builtin_prefetch(&sums[vertex], 1); };
    forEachTerm(tetrahedra, corners, prefetch, [&](const GradientSum& term, std::size_t t) {
        for (const std::uint32_t vertex : tetrahedra[t])
            sums[vertex].add(term);
    });
}

/// The same sums bit for bit, on all threads: the terms of a piece of the mesh, then for each share of the vertices
/// theirs, in the order of the tetrahedra.
class SharedSums {
public:
    SharedSums(std::span<GradientSum> sums, int threads) : sums_(sums)
    {
        constexpr std::size_t sharesOfThread = 4;
        while (sums.size() >> shareBits_ >= sharesOfThread * static_cast<std::size_t>(threads))
            ++shareBits_;
        shareCount_ = static_cast<std::uint32_t>(sums.size() >> shareBits_) + 1;
    }

    void add(Tetrahedra tetrahedra, const Buffer<Corner>& corners)
    {
        terms_.resize(std::min(tetrahedra.size(), pieceSize));
        for (std::size_t first = 0; first < tetrahedra.size(); first += pieceSize)
            addPiece(tetrahedra.subspan(first, std::min(pieceSize, tetrahedra.size() - first)), corners);
    }

private:
    static constexpr std::size_t runSize = 1 << 14;
    static constexpr std::size_t pieceSize = 64 * runSize;

    /// A term on its way to a vertex.
    struct Entry {
        std::uint32_t vertex;
        std::uint32_t term;
    };
    /// Some tetrahedra. Where their vertices lie in few shares, as in spatial order, each of these looks at all of
    /// them; else the entries are sorted by shares.
    struct Run {
        std::uint32_t leastShare = 0, largestShare = 0;
        Buffer<Entry> entries;
        std::vector<std::uint32_t> ends; ///< of the shares' entries

        bool isSorted() const { return largestShare - leastShare >= 3; }
    };

    void addPiece(Tetrahedra tetrahedra, const Buffer<Corner>& corners)
    {
        const std::size_t count = (tetrahedra.size() + runSize - 1) / runSize;
        runs_.resize(std::max(runs_.size(), count));
        const auto first = [](std::size_t run) { return run * runSize; };
        const auto ofRun = [&](std::size_t run) {
            return tetrahedra.subspan(first(run), std::min(runSize, tetrahedra.size() - first(run)));
        };
        tbb::parallel_for(std::size_t(0), count,
                          [&](std::size_t run) { fillRun(runs_[run], ofRun(run), first(run), corners); });
        tbb::parallel_for(std::uint32_t(0), shareCount_, [&](std::uint32_t share) {
            for (std::size_t run = 0; run < count; ++run)
                if (runs_[run].leastShare <= share && share <= runs_[run].largestShare)
                    addRun(runs_[run], ofRun(run), first(run), share);
        });
    }

    void fillRun(Run& run, Tetrahedra tetrahedra, std::size_t firstTerm, const Buffer<Corner>& corners)
    {
        std::uint32_t least = 0xffffffff, largest = 0;
        forEachTerm(
            tetrahedra, corners, [](std::uint32_t) {},
            [&](const GradientSum& term, std::size_t t) {
                terms_[firstTerm + t] = term;
                for (const std::uint32_t vertex : tetrahedra[t]) {
                    least = std::min(least, vertex);
                    largest = std::max(largest, vertex);
                }
            });
        run.leastShare = least >> shareBits_;
        run.largestShare = largest >> shareBits_;
        if (run.isSorted())
            sortEntries(run, tetrahedra, firstTerm);
    }

    void sortEntries(Run& run, Tetrahedra tetrahedra, std::size_t firstTerm) const
    {
        std::vector<std::uint32_t>& places = run.ends;
        places.assign(shareCount_ + 1, 0);
        for (const auto& vertices : tetrahedra)
            for (const std::uint32_t vertex : vertices)
                ++places[(vertex >> shareBits_) + 1];
        for (std::size_t share = 0; share < shareCount_; ++share)
            places[share + 1] += places[share];
        run.entries.resize(4 * tetrahedra.size());
        for (std::size_t t = 0; t < tetrahedra.size(); ++t)
            for (const std::uint32_t vertex : tetrahedra[t])
                run.entries[places[vertex >> shareBits_]++] = {vertex, static_cast<std::uint32_t>(firstTerm + t)};
    }

    void addRun(const Run& run, Tetrahedra tetrahedra, std::size_t firstTerm, std::uint32_t share)
    {
        if (run.isSorted()) {
            for (std::uint32_t i = share == 0 ? 0 : run.ends[share - 1]; i < run.ends[share]; ++i)
                sums_[run.entries[i].vertex].add(terms_[run.entries[i].term]);
            return;
        }
        for (std::size_t t = 0; t < tetrahedra.size(); ++t)
            for (const std::uint32_t vertex : tetrahedra[t])
                if (vertex >> shareBits_ == share)
                    sums_[vertex].add(terms_[firstTerm + t]);
    }

    std::span<GradientSum> sums_;
    unsigned shareBits_ = 0;
    std::uint32_t shareCount_ = 0;
    Buffer<GradientSum> terms_;
    std::vector<Run> runs_;
};

} // namespace

Buffer<Eigen::Vector3f> vertexGradients(const TetrahedralMesh& mesh)
{
    const std::size_t count = mesh.positions.size();
    Buffer<Eigen::Vector3f> gradients(count);
    const Buffer<Corner> corners = makeCorners(mesh);
    std::vector<GradientSum> sums(count);
    const int threads = tbb::this_task_arena::max_concurrency();
    if (threads == 1)
        addUp(mesh.tetrahedra, corners, sums);
    else
        SharedSums(sums, threads).add(mesh.tetrahedra, corners);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 15), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            gradients[v] =
                sums[v].volume > 0 ? Eigen::Vector3f(sums[v].gradient / sums[v].volume) : Eigen::Vector3f(0, 0, 0);
    });
    return gradients;
}

} // namespace tetra
