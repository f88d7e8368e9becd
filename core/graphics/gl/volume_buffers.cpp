// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/volume_buffers.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace tetra {
namespace {

/// Every OpenGL 3.3 allows twice as many texels in a texture buffer.
constexpr std::size_t cellsPerChunk = 1 << 15;
/// Texels of a segment in slab.frag.
constexpr std::size_t segmentTexels = 3;

static_assert(sizeof(CellClass) == 4, "two numbers of 16 bits, a texel");

Error outOfMemory()
{
    return {ErrorKind::OutOfResource, "The graphics card has not enough memory for this volume. Lower the accuracy of "
                                      "the mesh, or use the CPU back end."};
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

} // namespace

Status fillVertices(const GlFunctions& gl, const TetrahedralMesh& mesh, VolumeBuffers& buffers)
{
    int limit = 0;
    gl.getIntegerv(gl::maximumTextureBufferSize, &limit);
    if (mesh.positions.size() > static_cast<std::size_t>(limit))
        return Error{ErrorKind::OutOfResource, "This OpenGL driver draws volumes of at most " + std::to_string(limit) +
                                                   " vertices. Lower the accuracy of the mesh, or use the CPU back "
                                                   "end."};
    Buffer<std::array<float, 4>> vertices(mesh.positions.size());
    tbb::parallel_for(std::size_t(0), vertices.size(), [&](std::size_t i) {
        const Eigen::Vector3f& place = mesh.positions[i];
        vertices[i] = {place.x(), place.y(), place.z(), mesh.values[i]};
    });
    fillTextureBuffer(gl, buffers.vertices, gl::rgba32f, byteCount(vertices));
    return gl.getError() == gl::outOfMemory ? Status(outOfMemory()) : Status();
}

Status fillCells(const GlFunctions& gl, const TetrahedralMesh& mesh, const VolumeTransfer& transfer,
                 VolumeBuffers& buffers)
{
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

Result<VolumeBuffers*> VolumeBufferCache::buffersOf(const std::shared_ptr<const VolumeMesh>& mesh)
{
    const auto found = entries_.find(mesh.get());
    if (found != entries_.end() && !found->second.mesh.expired())
        return &found->second.buffers;
    VolumeBuffers buffers;
    if (Status status = fillVertices(gl_, *mesh->mesh, buffers); !status)
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
