// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_mesh.h"

#include "core/graphics/volume/boundary_convexity.h"

#include <algorithm>
#include <new>

namespace tetra {
namespace {

Error notEnoughMemory()
{
    return {ErrorKind::OutOfResource,
            "Not enough memory to draw this mesh as a volume. Close other programs or lower the accuracy of the mesh."};
}

Status checkCells(const TetrahedralMesh& mesh)
{
    if (mesh.values.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage, "The mesh and its values do not belong together."};
    if (mesh.tetrahedra.size() >= largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource, "The mesh has more than a thousand million tetrahedra, too many to be "
                                               "drawn at once. Lower its accuracy."};
    const std::size_t vertices = mesh.positions.size();
    const auto exists = [&](std::uint32_t vertex) { return vertex < vertices; };
    if (!std::ranges::all_of(mesh.tetrahedra, [&](const auto& cell) { return std::ranges::all_of(cell, exists); }))
        return Error{ErrorKind::WrongUsage, "A tetrahedron has a corner that does not exist."};
    return {};
}

Eigen::AlignedBox3d boundsOf(const TetrahedralMesh& mesh)
{
    Eigen::AlignedBox3f bounds;
    for (const Eigen::Vector3f& position : mesh.positions)
        if (position.allFinite())
            bounds.extend(position);
    return bounds.isEmpty() ? Eigen::AlignedBox3d() : bounds.cast<double>();
}

} // namespace

Result<VolumeMesh> makeVolumeMesh(std::shared_ptr<const TetrahedralMesh> mesh)
{
    if (Status status = checkCells(*mesh); !status)
        return status.error();
    try {
        VolumeMesh result;
        result.adjacency = matchFaces(mesh->tetrahedra);
        result.bounds = boundsOf(*mesh);
        result.convex = hasConvexBoundary(*mesh, result.adjacency);
        result.mesh = std::move(mesh);
        return result;
    } catch (const std::bad_alloc&) {
        return notEnoughMemory();
    }
}

Result<VolumeTransfer> makeVolumeTransfer(const TetrahedralMesh& mesh, const TransferFunction& function)
{
    if (Status status = checkTransferFunction(function); !status)
        return status.error();
    VolumeTransfer result;
    result.segments = transferSegments(function);
    if (result.segments.size() > largestSegmentCount)
        return Error{ErrorKind::OutOfResource, "The transfer function has more than 65,000 points. Leave some out."};
    try {
        result.classes = classifyCells(mesh, result.segments);
        return result;
    } catch (const std::bad_alloc&) {
        return notEnoughMemory();
    }
}

Eigen::AlignedBox3d drawnBounds(const Scene& scene)
{
    return hasVolume(scene) ? scene.bounds.merged(scene.volume->mesh->bounds) : scene.bounds;
}

} // namespace tetra
