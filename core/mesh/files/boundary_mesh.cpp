// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes in the formats for surfaces: the boundary is written.
#include "core/mesh/boundary_faces.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/files/mesh_formats.h"
#include "core/mesh/files/surface_file.h"

namespace tetra {

namespace {

/// The vertices' first array of floats.
const NamedArray* valuesOf(const MeshContent& content)
{
    for (const NamedArray& array : content.pointArrays)
        if (std::holds_alternative<std::span<const float>>(array.values))
            return &array;
    return nullptr;
}

} // namespace

Status writeBoundary(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    constexpr double found = 0.4;
    if (content.tetrahedra.size() > largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource, "'" + path.string() +
                                                   "' would be the boundary of more than 1073741824 tetrahedra, which "
                                                   "is too many to find it. Write a .vtu file."};
    progress.report(0, writingMesh);
    const BoundaryFaces boundary = boundaryFaces(content.positions.size(), content.tetrahedra);
    if (progress.cancelled())
        return cancelledError(writingMesh);
    std::vector<Eigen::Vector3f> positions;
    std::vector<float> values;
    const NamedArray* const array = valuesOf(content);
    for (const std::uint32_t vertex : boundary.vertices) {
        positions.push_back(content.positions[vertex]);
        if (array != nullptr)
            values.push_back(std::get<std::span<const float>>(array->values)[vertex]);
    }
    SurfacePart part{.name = "boundary", .positions = positions, .normals = {}, .triangles = boundary.triangles};
    if (array != nullptr)
        part.values = std::span<const float>(values);
    return writeSurfaceFile(
        path, {"boundary of a tetrahedral mesh", array != nullptr ? array->name : "value", {part}, content.facts},
        progress.part(found, 1));
}

} // namespace tetra
