// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_functions.h"
#include "core/render/volume/projected_vertices.h"
#include "core/render/volume/volume_renderer.h"

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace tetra {

/// An object of OpenGL that is made and deleted by functions of this shape: a buffer, a texture ... The context must be
/// current when it goes. Moves, does not copy.
class GlObject {
public:
    GlObject() = default;
    GlObject(GlFunctions::Function<GlFunctions::Names> generate,
             GlFunctions::Function<GlFunctions::ConstantNames> deleteNames)
        : deleteNames_(deleteNames)
    {
        generate(1, &name_);
    }
    GlObject(GlObject&& other) noexcept : deleteNames_(other.deleteNames_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(deleteNames_, other.deleteNames_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject()
    {
        if (name_ != 0)
            deleteNames_(1, &name_);
    }

    unsigned name() const noexcept { return name_; }

private:
    GlFunctions::Function<GlFunctions::ConstantNames> deleteNames_ = nullptr;
    unsigned name_ = 0;
};

/// An array that shaders read as a texture.
struct TextureBuffer {
    GlObject buffer;
    GlObject texture;
};

/// A triangle mesh in the memory of the graphics card.
struct MeshBuffers {
    GlObject vertexArray;
    GlObject positions;
    GlObject normals;
    GlObject colours; ///< if the mesh has some
    GlObject triangles;
    int indexCount = 0;
    Eigen::Vector3d origin{0, 0, 0}; ///< the positions are relative to it
};

/// Keeps the buffers of every mesh that still lives, so that a mesh is sent once. The context must be current for
/// everything, also when it goes; `gl` must outlive it.
class MeshBufferCache {
public:
    explicit MeshBufferCache(const GlFunctions& gl) : gl_(gl) {}

    /// The buffers of `mesh`, valid until dropDead(); sent anew where their origin is too far from what the camera
    /// looks at. Errors: a mesh that does not hang together, out of memory.
    Result<const MeshBuffers*> buffersOf(const std::shared_ptr<const TriangleMesh>& mesh, const Camera& camera);
    /// Frees the buffers of meshes that nobody holds any more.
    void dropDead();

private:
    struct Entry {
        std::weak_ptr<const TriangleMesh> mesh; ///< tells a new mesh at an old address
        MeshBuffers buffers;
    };
    Result<MeshBuffers> upload(const TriangleMesh& mesh, const Eigen::Vector3d& origin) const;

    const GlFunctions& gl_;
    std::map<const TriangleMesh*, Entry> entries_;
};

/// Some of the cells that are drawn, front to back: their corners, and the segments of the transfer function that they
/// lie in. So few that a texture buffer holds them everywhere.
struct CellChunk {
    TextureBuffer corners;
    TextureBuffer segments;
    int count = 0;
};

/// A volume in the memory of the graphics card: 32 bytes a vertex, 20 a visible cell.
struct VolumeBuffers {
    TextureBuffer vertices;  ///< places relative to `origin`, and values
    TextureBuffer gradients; ///< VolumeMesh::gradients
    Eigen::Vector3d origin{0, 0, 0};
    std::size_t vertexCount = 0; ///< more than the mesh has where cells were cut
    std::vector<CellChunk> chunks;
    std::size_t cells = 0;     ///< in all chunks
    std::size_t sentBytes = 0; ///< for them
    CachedOrder order;         ///< that the chunks are in
    std::weak_ptr<const VolumeTransfer> transfer;
};

/// Sends the cells of buffers.order, which was made for the volume's mesh, of which something is seen; where cells were
/// cut for it, the vertices as well. Errors: more vertices than the driver allows, out of memory.
Status fillCells(const GlFunctions& gl, const Volume& volume, VolumeBuffers& buffers);
/// Three texels for each segment, as slab.frag reads them.
void fillSegments(const GlFunctions& gl, const ScaledSegments& segments, TextureBuffer& buffer);
/// Sends OpticalModel::rayData.
void fillRayData(const GlFunctions& gl, std::span<const std::array<float, 4>> data, TextureBuffer& buffer);

/// Keeps the buffers of every mesh that still lives. The context must be current for everything, also when it goes;
/// `gl` must outlive it.
class VolumeBufferCache {
public:
    explicit VolumeBufferCache(const GlFunctions& gl) : gl_(gl) {}

    /// The buffers of `mesh`, with its vertices, valid until dropDead(); these are sent anew where their origin is too
    /// far from what the camera looks at. Errors: those of fillVertices().
    Result<VolumeBuffers*> buffersOf(const std::shared_ptr<const VolumeMesh>& mesh, const Camera& camera);
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
