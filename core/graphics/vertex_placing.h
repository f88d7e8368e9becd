// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "core/graphics/surface_runs.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <compare>
#include <span>
#include <vector>

namespace tetra {

/// A vertex of a surface that lies in a vertex of the mesh, as all do whose edge ends there with the isovalue.
struct Tie {
    std::uint32_t meshVertex;
    std::uint32_t vertex;
    auto operator<=>(const Tie&) const = default;
};

/// What placing vertices found that needs more work.
struct PlacingFindings {
    std::vector<Tie> ties;       ///< sorted
    bool normalsMissing = false; ///< somewhere the gradient has no direction; the normal there is zero
};

/// Gives `surface` a position and a normal for each of the edges. Positions are interpolated in double precision; as
/// both ends are on different sides, the fraction of the way is defined, and where a value is infinite or NaN it is
/// some number in [0, 1]. Normals are unit vectors against the gradient, interpolated likewise. O(edges), on all
/// threads. May throw std::bad_alloc.
PlacingFindings placeVertices(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                              std::span<const EdgeKey> edges, double isovalue, TriangleMesh& surface);

} // namespace tetra
