// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/storage_buffer.h"
#include "core/graphics/volume/volume_mesh.h"

namespace tetra {

/// A mesh in the memory of the graphics card: 16 bytes a vertex, 16 a cell, and 16 more where the card orders the
/// cells.
struct CardMesh {
    StorageBuffer vertices;   ///< places and values, as they are
    StorageBuffer corners;    ///< of the cells
    StorageBuffer neighbours; ///< FaceAdjacency::neighbours, if the domain is convex
    std::size_t vertexCount = 0;
    std::size_t cellCount = 0;
};

/// Sends a mesh. Errors: larger than what the driver's shaders can read, out of memory.
Status fillMesh(const ComputeContext& context, const VolumeMesh& volume, CardMesh& mesh);

/// An error if the driver has refused something since the last time, which is mostly for want of memory.
Status checkDriver(const ComputeContext& context);

} // namespace tetra
