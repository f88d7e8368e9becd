// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/render/isosurface/crossed_tetrahedra.h"
#include "core/render/isosurface/isosurface.h"
#include "core/render/scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tetra {

/// Numbers 64-bit keys by their first appearance: a hash table by open addressing. Its memory is used again after
/// clear().
class EdgeTable {
public:
    /// What takes keys, small enough to be kept in registers.
    struct Numbering {
        std::uint32_t* slots;
        std::uint64_t* keys;
        std::size_t mask;
        int shift;
        std::uint32_t count;

        /// Whether the key is new is hard to predict, so that decides no branch.
        std::uint32_t numberOf(std::uint64_t key) noexcept
        {
            keys[count] = key;
            for (std::size_t slot = placeOf(key, shift);; slot = (slot + 1) & mask) {
                const std::uint32_t known = slots[slot];
                const std::uint32_t number = std::min(known, count); // unknown is the largest number
                slots[slot] = number;
                if (keys[number] == key) {
                    count += number == count ? 1 : 0;
                    return number;
                }
            }
        }
    };

    /// Forgets all keys. About so many are to come: to grow later is slow.
    void clear(std::size_t expected)
    {
        count_ = 0;
        makeSlots(std::bit_ceil(std::max(smallestTable, roomForOne * expected)));
    }
    /// Makes room for so many more keys. Hand back with end() what took them.
    Numbering begin(std::size_t more)
    {
        const std::size_t most = count_ + more + 1;
        if (keys_.size() < most)
            keys_.resize(std::max(most, 2 * keys_.size()));
        if (slots_.size() < roomForOne * most)
            makeSlots(std::bit_ceil(roomForOne * most));
        return {slots_.data(), keys_.data(), slots_.size() - 1, 64 - std::countr_zero(slots_.size()), count_};
    }
    void end(const Numbering& numbering) { count_ = numbering.count; }
    std::span<const std::uint64_t> keys() const noexcept { return {keys_.data(), count_}; }

private:
    static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t smallestTable = 1 << 12;
    static constexpr std::size_t roomForOne = 8;

    static std::size_t placeOf(std::uint64_t key, int shift) noexcept { return key * 0x9e3779b97f4a7c15u >> shift; }

    void makeSlots(std::size_t size)
    {
        slots_.assign(size, unknown);
        const int shift = 64 - std::countr_zero(size);
        for (std::uint32_t number = 0; number < count_; ++number) {
            std::size_t slot = placeOf(keys_[number], shift);
            while (slots_[slot] != unknown)
                slot = (slot + 1) & (size - 1);
            slots_[slot] = number;
        }
    }

    Buffer<std::uint64_t> keys_;
    Buffer<std::uint32_t> slots_;
    std::uint32_t count_ = 0;
};

/// The piece of an isosurface in one run of surfaceChunkSize tetrahedra.
struct SurfaceChunk {
    std::vector<EdgeKey> edges;                     ///< that it crosses, each once, in order of appearance
    Buffer<std::array<std::uint32_t, 3>> triangles; ///< of indices among its edges
};

/// Marches through the tetrahedra that have corners on both sides; a vertex is inside if its value is at least
/// `isovalue` (S16). Without an index all are looked at. O(vertices + tetrahedra), on all threads. Incomplete if
/// cancelled. May throw std::bad_alloc.
std::vector<SurfaceChunk> makeSurfaceChunks(const TetrahedralMesh& mesh, const IsosurfaceIndex* index, double isovalue,
                                            const Progress& progress);

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
PlacingFindings placeVertices(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                              std::span<const EdgeKey> edges, double isovalue, TriangleMesh& surface);

/// Makes one vertex of those that lie in the same vertex of the mesh: the edges of a vertex whose value is the isovalue
/// all cross there. Keeps the order, and leaves out the triangles that have no area then; without welding, leaving them
/// out would tear the surface. O(vertices + triangles), all threads for triangles. May throw std::bad_alloc.
void weldAtMeshVertices(std::span<const CoincidentVertex> ties, TriangleMesh& surface);

} // namespace tetra
