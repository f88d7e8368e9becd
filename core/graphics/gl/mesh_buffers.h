// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_object.h"
#include "core/graphics/scene.h"

#include <Eigen/Core>

#include <map>
#include <memory>

namespace tetra {

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

    /// The buffers of `mesh`, valid until dropDead(). Errors: a mesh that does not hang together, out of memory.
    Result<const MeshBuffers*> buffersOf(const std::shared_ptr<const TriangleMesh>& mesh);
    /// Frees the buffers of meshes that nobody holds any more.
    void dropDead();

private:
    struct Entry {
        std::weak_ptr<const TriangleMesh> mesh; ///< tells a new mesh at an old address
        MeshBuffers buffers;
    };
    Result<MeshBuffers> upload(const TriangleMesh& mesh) const;

    const GlFunctions& gl_;
    std::map<const TriangleMesh*, Entry> entries_;
};

} // namespace tetra
