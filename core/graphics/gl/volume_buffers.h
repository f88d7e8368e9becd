// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/cpu/kept_order.h"
#include "core/graphics/gl/texture_buffer.h"
#include "core/graphics/scene.h"
#include "core/graphics/volume/scaled_segments.h"

#include <map>
#include <memory>
#include <vector>

namespace tetra {

/// Some of the cells that are drawn, front to back: their corners, and the segments of the transfer function that they
/// lie in. So few that a texture buffer holds them everywhere.
struct CellChunk {
    TextureBuffer corners;
    TextureBuffer segments;
    int count = 0;
};

/// A volume in the memory of the graphics card: 16 bytes a vertex, 20 a visible cell.
struct VolumeBuffers {
    TextureBuffer vertices; ///< places and values, as they are
    std::vector<CellChunk> chunks;
    std::size_t cells = 0;     ///< in all chunks
    std::size_t sentBytes = 0; ///< for them
    KeptOrder order;           ///< that the chunks are in
    std::weak_ptr<const VolumeTransfer> transfer;
};

/// Errors: more vertices than the driver allows, out of memory.
Status fillVertices(const GlFunctions& gl, const TetrahedralMesh& mesh, VolumeBuffers& buffers);
/// Sends the cells of buffers.order of which something is seen. Error: out of memory.
Status fillCells(const GlFunctions& gl, const TetrahedralMesh& mesh, const VolumeTransfer& transfer,
                 VolumeBuffers& buffers);
/// Three texels for each segment, as slab.frag reads them.
void fillSegments(const GlFunctions& gl, const ScaledSegments& segments, TextureBuffer& buffer);

/// Keeps the buffers of every mesh that still lives. The context must be current for everything, also when it goes;
/// `gl` must outlive it.
class VolumeBufferCache {
public:
    explicit VolumeBufferCache(const GlFunctions& gl) : gl_(gl) {}

    /// The buffers of `mesh`, with its vertices, valid until dropDead(). Errors: those of fillVertices().
    Result<VolumeBuffers*> buffersOf(const std::shared_ptr<const VolumeMesh>& mesh);
    /// Frees the buffers of meshes that nobody holds any more.
    void dropDead();

private:
    struct Entry {
        std::weak_ptr<const VolumeMesh> mesh; ///< tells a new mesh at an old address
        VolumeBuffers buffers;
    };

    const GlFunctions& gl_;
    std::map<const VolumeMesh*, Entry> entries_;
};

} // namespace tetra
