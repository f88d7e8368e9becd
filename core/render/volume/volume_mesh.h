// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_adjacency.h"

#include <tan/render.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// The segments of the transfer function that a cell's values lie in, first to last.
struct CellClass {
    static constexpr std::uint16_t nothing = 0xffff;
    std::uint16_t first = nothing;
    std::uint16_t last = nothing;
    bool visible() const noexcept { return first != nothing; }
};

/// The most segments that a class can name.
inline constexpr std::size_t largestSegmentCount = 0xfffe;

/// Tells the cells that show something: those with values in a segment that is not transparent, and no corner without
/// a finite value or place. O(vertices log segments + cells), on all threads of the current arena. May throw
/// std::bad_alloc.
Buffer<CellClass> classifyCells(const TetrahedralMesh& mesh, std::span<const TransferSegment> segments);

/// Whether the domain of a mesh is convex, but for dents no deeper than a hundred thousandth of its own size: no two
/// faces of the boundary meet at an edge that is bent inwards, each edge has two of them, and they hang together. False
/// if in doubt. O(cells + boundary log boundary), one thread. May throw std::bad_alloc.
bool hasConvexBoundary(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency);

/// A mesh made ready to be drawn as a volume, once. Immutable; share it between threads.
struct VolumeMesh {
    std::shared_ptr<const TetrahedralMesh> mesh;
    FaceAdjacency adjacency;
    Eigen::AlignedBox3d bounds; ///< of the vertices of its cells
    bool convex = false;        ///< the domain is known to be convex: no ray leaves it and comes back
    /// Where the field rises at the vertices, for light: vertexGradients() by one factor for all, so that none is
    /// longer than 1; zero where there is none.
    Buffer<Eigen::Vector3f> gradients{};
    double longestGradient = 0; ///< that factor
};

/// Matches the faces and takes gradients. O(cells), 100 bytes a cell while it runs and 20 in spatial order, 17 after,
/// and 12 a vertex. Errors: arrays that
/// do not belong together, corners that do not exist, too many cells, not enough memory.
Result<VolumeMesh> makeVolumeMesh(std::shared_ptr<const TetrahedralMesh> mesh);

/// A transfer function made ready for a mesh.
struct VolumeTransfer {
    std::vector<TransferSegment> segments;
    Buffer<CellClass> classes; ///< of the mesh's cells
};

/// O(cells). Errors: no transfer function (checkTransferFunction), too many points, not enough memory.
Result<VolumeTransfer> makeVolumeTransfer(const TetrahedralMesh& mesh, const TransferFunction& function);

/// The volume that is drawn, of a blend the one outside of its region; null if there is none.
const Volume* volumeOf(const Scene& scene);
/// How much of its extinction a volume has for one unit of gradients of which 1 is this long; 0 if it has all anywhere.
inline float perFullGradient(double fullGradient, double unitOfGradients)
{
    const double most = std::numeric_limits<float>::max();
    return fullGradient > 0 ? static_cast<float>(std::min(unitOfGradients / fullGradient, most)) : 0;
}
/// The blend that it is a part of, if both its volumes can be drawn; else null.
const FocusVolume* focusOf(const Scene& scene);
/// The samples that are drawn; null if there are none.
const SampledVolume* samplesOf(const Scene& scene);
/// An error if there is more than one volume or blend, or one whose parts do not belong together.
Status checkVolumes(const Scene& scene);

/// How the pieces of a ray through a volume are combined: put over each other unless its model says otherwise.
inline Combiner combinerOf(const Volume& volume)
{
    return volume.model ? volume.model->combiner : Combiner::Over;
}

/// Of all that is drawn: near and far must be those of surfaces and volume alike.
Eigen::AlignedBox3d drawnBounds(const Scene& scene);

} // namespace tetra
