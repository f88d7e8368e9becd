// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/card_mesh.h"

#include <algorithm>
#include <array>
#include <string>

#include <tbb/parallel_for.h>

namespace tetra {
namespace {

constexpr std::size_t bytesPerItem = 16; // of a vertex, and of a cell's corners or neighbours

Status checkSizes(const ComputeContext& context, const TetrahedralMesh& mesh)
{
    int bytes = 0;
    int texels = 0;
    context.gl.getIntegerv(gl::maximumShaderStorageBlockSize, &bytes);
    context.gl.getIntegerv(gl::maximumTextureBufferSize, &texels);
    const std::size_t most = static_cast<std::size_t>(std::max(bytes, 0)) / bytesPerItem;
    if (mesh.tetrahedra.size() < most && mesh.positions.size() <= std::min(most, static_cast<std::size_t>(texels)))
        return {};
    return Error{ErrorKind::OutOfResource,
                 "This driver's compute shaders read at most " + std::to_string(most) + " tetrahedra or vertices."};
}

} // namespace

Status checkDriver(const ComputeContext& context)
{
    if (const unsigned code = context.gl.getError(); code != 0)
        return Error{ErrorKind::OutOfResource, code == gl::outOfMemory
                                                   ? "The graphics card has not enough memory for its compute shaders."
                                                   : "The OpenGL driver refuses a compute shader's work, with error " +
                                                         std::to_string(code) + "."};
    return {};
}

Status fillMesh(const ComputeContext& context, const VolumeMesh& volume, CardMesh& mesh)
{
    const TetrahedralMesh& from = *volume.mesh;
    if (Status status = checkSizes(context, from); !status)
        return status;
    mesh.vertexCount = from.positions.size();
    mesh.cellCount = from.tetrahedra.size();
    Buffer<std::array<float, 4>> vertices(mesh.vertexCount);
    tbb::parallel_for(std::size_t(0), vertices.size(), [&](std::size_t i) {
        const Eigen::Vector3f& place = from.positions[i];
        vertices[i] = {place.x(), place.y(), place.z(), from.values[i]};
    });
    mesh.vertices.fill(context, std::as_bytes(std::span(vertices)));
    mesh.corners.fill(context, std::as_bytes(std::span(from.tetrahedra)));
    if (volume.convex)
        mesh.neighbours.fill(context, std::as_bytes(std::span(volume.adjacency.neighbours)));
    return checkDriver(context);
}

} // namespace tetra
