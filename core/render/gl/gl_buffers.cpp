// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/gl_buffers.h"

#include "core/render/mesh_origin.h"
#include "core/render/scene_checks.h"

#include <tan/render.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace tetra {

namespace {

/// Whether floats relative to `origin` are too coarse for what a camera looks at: it is so near that they err by more
/// than some 1e-5 of its distance, and relative to its target they do not.
bool isTooFar(const Eigen::Vector3d& origin, const Camera& camera)
{
    constexpr double reach = 256;
    return (eyePosition(camera) - origin).norm() > reach * camera.distance &&
           (camera.target - origin).norm() > camera.distance;
}

/// Sends `data` into `target`, which is made if it is empty; `format` is that of a texel and stays the same.
void fillTextureBuffer(const GlFunctions& gl, TextureBuffer& target, unsigned format, std::span<const std::byte> data,
                       unsigned usage = gl::staticDraw)
{
    const bool isNew = target.buffer.name() == 0;
    if (isNew)
        target = {{gl.genBuffers, gl.deleteBuffers}, {gl.genTextures, gl.deleteTextures}};
    gl.bindBuffer(gl::textureBuffer, target.buffer.name());
    gl.bufferData(gl::textureBuffer, static_cast<std::ptrdiff_t>(data.size()), data.data(), usage);
    gl.bindBuffer(gl::textureBuffer, 0);
    if (!isNew)
        return;
    gl.bindTexture(gl::textureBuffer, target.texture.name());
    gl.texBuffer(gl::textureBuffer, format, target.buffer.name());
    gl.bindTexture(gl::textureBuffer, 0);
}

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

} // namespace

Result<MeshBuffers> MeshBufferCache::upload(const TriangleMesh& mesh, const Eigen::Vector3d& origin) const
{
    if (Status status = checkMesh(mesh); !status)
        return status.error();
    const Buffer<std::uint32_t> corners = drawableCorners(mesh);
    if (corners.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return Error{ErrorKind::OutOfResource,
                     Message::say("A surface has too many triangles for OpenGL. Use the CPU back end.")};
    MeshBuffers buffers;
    buffers.indexCount = static_cast<int>(corners.size());
    buffers.origin = origin;
    Buffer<Eigen::Vector3f> relative(mesh.positions.size());
    std::ranges::transform(mesh.positions, relative.begin(), [&](const Eigen::Vector3d& position) {
        return Eigen::Vector3f((position - buffers.origin).cast<float>());
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
                     Message::say("The graphics card does not have enough memory for this surface. Lower the accuracy "
                                  "of the mesh, or use the CPU back end.")};
    return buffers;
}

Result<const MeshBuffers*> MeshBufferCache::buffersOf(const std::shared_ptr<const TriangleMesh>& mesh,
                                                      const Camera& camera)
{
    const auto found = entries_.find(mesh.get());
    const bool isKept = found != entries_.end() && !found->second.mesh.expired();
    if (isKept && !isTooFar(found->second.buffers.origin, camera))
        return &found->second.buffers;
    const Eigen::Vector3d first = meshOrigin(mesh->positions);
    Result<MeshBuffers> buffers = upload(*mesh, isTooFar(first, camera) ? camera.target : first);
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

namespace {

/// Every OpenGL 3.3 allows twice as many texels in a texture buffer.
constexpr std::size_t cellsPerChunk = 1 << 15;
/// Texels of a segment in slab.frag.
constexpr std::size_t segmentTexels = 3;

static_assert(sizeof(CellClass) == 4, "two numbers of 16 bits, a texel");

Error outOfMemory()
{
    return {ErrorKind::OutOfResource, Message::say("The graphics card does not have enough memory for this volume. "
                                                   "Lower the accuracy of the mesh, or use the CPU back end.")};
}

template <class Element> std::span<const std::byte> byteCount(const Element& elements)
{
    return std::as_bytes(std::span(elements));
}

/// What a chunk is made of.
struct ChunkData {
    Buffer<std::array<std::uint32_t, 4>> corners;
    Buffer<CellClass> segments;
};

ChunkData visibleCells(const TetrahedralMesh& mesh, const VolumeTransfer& transfer,
                       std::span<const std::uint32_t> order)
{
    ChunkData data;
    data.corners.resize(order.size());
    data.segments.resize(order.size());
    std::size_t count = 0;
    for (const std::uint32_t cell : order)
        if (transfer.classes[cell].visible()) {
            data.corners[count] = mesh.tetrahedra[cell];
            data.segments[count++] = transfer.classes[cell];
        }
    data.corners.resize(count);
    data.segments.resize(count);
    return data;
}

/// Relative to buffers.origin. Errors: more vertices than the driver allows, out of memory.
Status fillVertices(const GlFunctions& gl, const VolumeMesh& volume, VolumeBuffers& buffers)
{
    const TetrahedralMesh& mesh = *volume.mesh;
    int limit = 0;
    gl.getIntegerv(gl::maximumTextureBufferSize, &limit);
    if (mesh.positions.size() > static_cast<std::size_t>(limit))
        return Error{ErrorKind::OutOfResource, Message::say("This OpenGL driver draws volumes of at most %1 vertices. "
                                                            "Lower the accuracy of the mesh, or use the CPU back end.",
                                                            limit)};
    Buffer<std::array<float, 4>> vertices(mesh.positions.size()), gradients(mesh.positions.size());
    tbb::parallel_for(std::size_t(0), vertices.size(), [&](std::size_t i) {
        const Eigen::Vector3f place = (mesh.positions[i] - buffers.origin).cast<float>();
        vertices[i] = {place.x(), place.y(), place.z(), mesh.values[i]};
        const Eigen::Vector3f& gradient = volume.gradients[i];
        gradients[i] = {gradient.x(), gradient.y(), gradient.z(), 0};
    });
    fillTextureBuffer(gl, buffers.vertices, gl::rgba32f, byteCount(vertices));
    fillTextureBuffer(gl, buffers.gradients, gl::rgba32f, byteCount(gradients));
    buffers.vertexCount = vertices.size();
    return gl.getError() == gl::outOfMemory ? Status(outOfMemory()) : Status();
}

} // namespace

Status fillCells(const GlFunctions& gl, const Volume& volume, VolumeBuffers& buffers)
{
    const Volume cut = buffers.order.withPieces(volume);
    const TetrahedralMesh& mesh = *cut.mesh->mesh;
    const VolumeTransfer& transfer = *cut.transfer;
    if (buffers.order.cutCells() > 0 || buffers.vertexCount != mesh.positions.size())
        if (Status status = fillVertices(gl, *cut.mesh, buffers); !status)
            return status;
    const std::span<const std::uint32_t> order = buffers.order.cells();
    std::vector<ChunkData> data((order.size() + cellsPerChunk - 1) / cellsPerChunk);
    tbb::parallel_for(std::size_t(0), data.size(), [&](std::size_t i) {
        const std::size_t first = i * cellsPerChunk;
        data[i] = visibleCells(mesh, transfer, order.subspan(first, std::min(cellsPerChunk, order.size() - first)));
    });
    std::erase_if(data, [](const ChunkData& chunk) { return chunk.corners.empty(); });
    buffers.chunks.resize(data.size());
    buffers.cells = 0;
    buffers.sentBytes = 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
        CellChunk& chunk = buffers.chunks[i];
        fillTextureBuffer(gl, chunk.corners, gl::rgba32ui, byteCount(data[i].corners), gl::streamDraw);
        fillTextureBuffer(gl, chunk.segments, gl::rg16ui, byteCount(data[i].segments), gl::streamDraw);
        chunk.count = static_cast<int>(data[i].corners.size());
        buffers.cells += data[i].corners.size();
        buffers.sentBytes += byteCount(data[i].corners).size() + byteCount(data[i].segments).size();
    }
    return gl.getError() == gl::outOfMemory ? Status(outOfMemory()) : Status();
}

void fillSegments(const GlFunctions& gl, const ScaledSegments& segments, TextureBuffer& buffer)
{
    std::vector<std::array<float, 4>> texels;
    texels.reserve(segments.segments.size() * segmentTexels);
    for (const ScaledSegment& segment : segments.segments) {
        const auto& [red, green, blue] = segment.colour;
        const auto& [redPerValue, greenPerValue, bluePerValue] = segment.colourPerValue;
        texels.push_back({segment.begin, segment.end, segment.origin, segment.transparent ? 1.0f : 0.0f});
        texels.push_back({segment.halfExtinction, segment.halfExtinctionPerValue, red, green});
        texels.push_back({blue, redPerValue, greenPerValue, bluePerValue});
    }
    fillTextureBuffer(gl, buffer, gl::rgba32f, byteCount(texels), gl::streamDraw);
}

void fillRayData(const GlFunctions& gl, std::span<const std::array<float, 4>> data, TextureBuffer& buffer)
{
    fillTextureBuffer(gl, buffer, gl::rgba32f, byteCount(data), gl::streamDraw);
}

Result<VolumeBuffers*> VolumeBufferCache::buffersOf(const std::shared_ptr<const VolumeMesh>& mesh, const Camera& camera)
{
    const auto found = entries_.find(mesh.get());
    const bool isKept = found != entries_.end() && !found->second.mesh.expired();
    if (isKept && !isTooFar(found->second.buffers.origin, camera))
        return &found->second.buffers;
    const Eigen::Vector3d first = meshOrigin(mesh->mesh->positions);
    VolumeBuffers buffers;
    buffers.origin = isTooFar(first, camera) ? camera.target : first;
    if (Status status = fillVertices(gl_, *mesh, buffers); !status)
        return status.error();
    Entry& entry = entries_[mesh.get()];
    entry = {mesh, std::move(buffers)};
    return &entry.buffers;
}

void VolumeBufferCache::dropDead()
{
    std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
}

} // namespace tetra
