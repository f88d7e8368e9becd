// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/facing.h"
#include "core/mesh/face_adjacency.h"
#include "tests/core/graphics/volume/volume_meshes.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace tetra::testing {

/// Delaunay meshes of points on a lattice, most of them cospherical with others, and of points anywhere.
std::vector<NamedMesh> delaunayMeshes();

/// Eyes from anywhere outside and inside of a box, in planes of the lattice and hardly beside them; by turns in
/// perspective and not.
std::vector<EyePoint> eyesAround(const Eigen::AlignedBox3d& bounds, std::size_t count, std::mt19937& random);

/// Faces between two cells: how many have the eye on one side, and of how many the cell on that side does not have the
/// smaller rank. Exact arithmetic, without a tolerance.
struct FacesInOrder {
    std::size_t compared = 0;
    std::size_t wrong = 0;
};
FacesInOrder checkFaces(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency, const EyePoint& eye,
                        std::span<const std::uint32_t> ranks);

} // namespace tetra::testing
