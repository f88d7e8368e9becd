// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <memory>

namespace tetra {

/// The same mesh with what lies near in space near in memory: vertices along a Hilbert curve (corners are renumbered,
/// vertices without tetrahedra stay), tetrahedra by their smallest vertex. Drawing, ordering and contouring wait for
/// memory several times less than in order of construction, and chunks of tetrahedra have narrow ranges of values. Once
/// a mesh, before it is used many times. O(vertices + tetrahedra), on all threads of the current arena, the same result
/// with any number of them; 16 bytes a tetrahedron besides the result while it runs. Errors: arrays that do not belong
/// together, corners that do not exist, cancelled, not enough memory.
Result<TetrahedralMesh> inSpatialOrder(const TetrahedralMesh& mesh, const Progress& progress = {});

/// The values at the corners of some tetrahedra; what is NaN counts as minus infinity, outside of any isosurface.
struct ChunkRange {
    float smallest;
    float largest;

    /// Whether corners lie on both sides; at the isovalue is inside (S16).
    bool crossedAt(double isovalue) const noexcept
    {
        return static_cast<double>(smallest) < isovalue && static_cast<double>(largest) >= isovalue;
    }
};

/// Tetrahedra that are looked at together, or passed over together.
inline constexpr std::size_t rangedChunkSize = 64;

/// The values of each run of rangedChunkSize tetrahedra, in order. O(tetrahedra), on all threads of the current arena.
/// May throw std::bad_alloc.
Buffer<ChunkRange> chunkRanges(const TetrahedralMesh& mesh);

/// A mesh and, from when it is first asked for, the same mesh in spatial order. Share it between all that use the mesh.
/// Used from one thread at a time.
class OrderedMesh {
public:
    explicit OrderedMesh(std::shared_ptr<const TetrahedralMesh> mesh) : original_(std::move(mesh)) {}

    const std::shared_ptr<const TetrahedralMesh>& original() const noexcept { return original_; }
    bool isOrdered() const noexcept { return ordered_ != nullptr; }
    /// Errors: those of inSpatialOrder().
    Result<std::shared_ptr<const TetrahedralMesh>> ordered(const Progress& progress = {});

private:
    std::shared_ptr<const TetrahedralMesh> original_;
    std::shared_ptr<const TetrahedralMesh> ordered_;
};

} // namespace tetra
