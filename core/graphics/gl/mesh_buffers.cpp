// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/mesh_buffers.h"

#include "core/graphics/scene_check.h"

#include <algorithm>
#include <limits>
#include <span>

namespace tetra {
namespace {

template <class T>
void fillBuffer(const GlFunctions& gl, unsigned target, const GlObject& buffer, std::span<const T> data)
{
    gl.bindBuffer(target, buffer.name());
    gl.bufferData(target, static_cast<std::ptrdiff_t>(data.size_bytes()), data.data(), gl::staticDraw);
}

/// Three floats for each vertex.
template <class Triple>
void fillTriples(const GlFunctions& gl, unsigned attribute, const GlObject& buffer, std::span<const Triple> data)
{
    static_assert(sizeof(Triple) == 3 * sizeof(float));
    fillBuffer(gl, gl::arrayBuffer, buffer, data);
    gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(attribute, 3, gl::floatType, 0, 0, nullptr);
}

/// The corners of the triangles whose places are all finite.
Buffer<std::uint32_t> drawableCorners(const TriangleMesh& mesh)
{
    Buffer<std::uint32_t> corners;
    corners.reserve(mesh.triangles.size() * 3);
    for (const auto& triangle : mesh.triangles)
        if (std::ranges::all_of(triangle, [&](std::uint32_t v) { return mesh.positions[v].allFinite(); }))
            corners.insert(corners.end(), triangle.begin(), triangle.end());
    return corners;
}

Eigen::Vector3d originOf(const TriangleMesh& mesh)
{
    const auto finite = std::ranges::find_if(mesh.positions, [](const auto& position) { return position.allFinite(); });
    return finite == mesh.positions.end() ? Eigen::Vector3d(0, 0, 0) : finite->template cast<double>().eval();
}

} // namespace

Result<MeshBuffers> MeshBufferCache::upload(const TriangleMesh& mesh) const
{
    if (Status status = checkMesh(mesh); !status)
        return status.error();
    const Buffer<std::uint32_t> corners = drawableCorners(mesh);
    if (corners.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return Error{ErrorKind::OutOfResource, "A surface has too many triangles for OpenGL. Use the CPU back end."};
    MeshBuffers buffers;
    buffers.indexCount = static_cast<int>(corners.size());
    buffers.origin = originOf(mesh);
    Buffer<Eigen::Vector3f> relative(mesh.positions.size());
    std::ranges::transform(mesh.positions, relative.begin(), [&](const Eigen::Vector3f& position) {
        return Eigen::Vector3f((position.cast<double>() - buffers.origin).cast<float>());
    });

    buffers.vertexArray = {gl_.genVertexArrays, gl_.deleteVertexArrays};
    buffers.positions = {gl_.genBuffers, gl_.deleteBuffers};
    buffers.normals = {gl_.genBuffers, gl_.deleteBuffers};
    buffers.triangles = {gl_.genBuffers, gl_.deleteBuffers};
    gl_.bindVertexArray(buffers.vertexArray.name());
    fillTriples<Eigen::Vector3f>(gl_, 0, buffers.positions, relative);
    fillTriples<Eigen::Vector3f>(gl_, 1, buffers.normals, mesh.normals);
    if (!mesh.colours.empty()) {
        buffers.colours = {gl_.genBuffers, gl_.deleteBuffers};
        fillTriples<Colour>(gl_, 2, buffers.colours, mesh.colours);
    }
    fillBuffer(gl_, gl::elementArrayBuffer, buffers.triangles, std::span<const std::uint32_t>(corners));
    gl_.bindVertexArray(0);
    if (gl_.getError() == gl::outOfMemory)
        return Error{ErrorKind::OutOfResource,
                     "The graphics card has not enough memory for this surface. Lower the accuracy of the mesh, or use "
                     "the CPU back end."};
    return buffers;
}

Result<const MeshBuffers*> MeshBufferCache::buffersOf(const std::shared_ptr<const TriangleMesh>& mesh)
{
    const auto found = entries_.find(mesh.get());
    if (found != entries_.end() && !found->second.mesh.expired())
        return &found->second.buffers;
    Result<MeshBuffers> buffers = upload(*mesh);
    if (!buffers)
        return buffers.error();
    Entry& entry = entries_[mesh.get()];
    entry = {mesh, std::move(*buffers)};
    return &entry.buffers;
}

void MeshBufferCache::dropDead()
{
    std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
}

} // namespace tetra
