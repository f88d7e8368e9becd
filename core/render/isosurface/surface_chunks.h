// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/render/isosurface/crossed_tetrahedra.h"
#include "core/render/isosurface/isosurface.h"

#include <tan/base.h>
#include <tan/mesh.h>
#include <tan/render.h>

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Where a surface crosses an edge: a share from the first end, the middle where the values do not tell.
TETRA_SIMD_INLINE double crossingShare(double isovalue, double first, double second)
{
    const double share = (isovalue - first) / (second - first);
    return share >= 0 && share <= 1 ? share : 0.5;
}

/// One coordinate there. From the nearer end, so that either is met exactly: that is how vertices are found to be one.
TETRA_SIMD_INLINE double coordinateAt(double from, double to, double share)
{
    const double step = to - from;
    return share <= 0.5 ? from + share * step : to - (1 - share) * step;
}

/// The piece of an isosurface in one run of surfaceChunkSize tetrahedra.
struct SurfaceChunk {
    std::vector<EdgeKey> edges;                     ///< that it crosses, each once, in order of appearance
    Buffer<std::array<std::uint32_t, 3>> triangles; ///< of indices among its edges
};

/// Marches through the tetrahedra that have corners on both sides; a vertex is inside if its one of `values` is at
/// least `isovalue` (S16). Without an index all are looked at. O(vertices + tetrahedra), on all threads. Incomplete if
/// cancelled. May throw std::bad_alloc.
std::vector<SurfaceChunk> makeSurfaceChunks(const TetrahedralMesh& mesh, std::span<const float> values,
                                            const IsosurfaceIndex* index, double isovalue, const Progress& progress);

/// The vertices of an isosurface: one for each crossed edge of the mesh, whatever runs share the edge.
struct SurfaceVertices {
    Buffer<EdgeKey> edges; ///< that each vertex lies on
    /// The vertex of each of the runs' edges, run after run.
    Buffer<std::uint32_t> numbers;
    std::vector<std::size_t> firstOfRun; ///< among `numbers`, and after the last run the end
};

/// The largest number of edges of all runs together that numberVertices can number.
inline constexpr std::uint64_t largestRunEdgeCount = 0xffffffff;

/// Numbers the edges of a mesh with so many vertices. Most belong to one run only, as its index tells, or else the
/// edges at their smaller ends; the others are dealt by hash to a fixed number of parts, so that every hash table fits
/// the cache. O(edges), on all threads, and the same numbering with any number of them. May throw std::bad_alloc.
SurfaceVertices numberVertices(std::span<const SurfaceChunk> runs, const IsosurfaceIndex* index,
                               std::size_t vertexCount);

/// A vertex of a surface that lies in a vertex of the mesh, as all do whose edge ends there with the isovalue.
struct CoincidentVertex {
    std::uint32_t meshVertex;
    std::uint32_t vertex;
    auto operator<=>(const CoincidentVertex&) const = default;
};

/// What placing vertices found that needs more work.
struct PlacingFindings {
    std::vector<CoincidentVertex> ties; ///< sorted
    bool normalsMissing = false;        ///< somewhere the gradient has no direction; the normal there is zero
};

/// Gives `surface` a position and a normal for each of the edges. Positions are interpolated in double precision; as
/// both ends are on different sides, the fraction of the way is defined, and where a value is infinite or NaN it is
/// some number in [0, 1]. Normals are unit vectors against the gradient, interpolated likewise. O(edges), on all
/// threads. May throw std::bad_alloc.
PlacingFindings placeVertices(const TetrahedralMesh& mesh, std::span<const float> values,
                              std::span<const Eigen::Vector3f> gradients, std::span<const EdgeKey> edges,
                              double isovalue, TriangleMesh& surface);

/// Makes one vertex of those that lie in the same vertex of the mesh: the edges of a vertex whose value is the isovalue
/// all cross there. Of `edges`, those of the vertices, the first of each place stays. Keeps the order, and leaves out
/// the triangles that have no area then, of `cells`, if given, likewise; without welding, leaving them out would tear
/// the surface. O(vertices + triangles), all threads for triangles. May throw std::bad_alloc.
void weldAtMeshVertices(std::span<const CoincidentVertex> ties, TriangleMesh& surface, Buffer<EdgeKey>& edges,
                        Buffer<std::uint32_t>* cells = nullptr);

} // namespace tetra
