// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_adjacency.h"
#include "core/render/order/face_classification.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/volume/volume_meshes.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace tetra::testing {

/// Delaunay meshes of points on a lattice, most of them cospherical with others, and of points anywhere.
std::vector<NamedMesh> delaunayMeshes();

/// A lattice of other proportions, whose cubes are cut as in latticeMesh(): Delaunay still, all cells of a cube
/// cospherical.
TetrahedralMesh boxLattice(std::uint32_t cells, Split split);
/// Points moved from the lattice by `most` along each axis at random, so that it is Delaunay no more, but still fills
/// its box of 10^3.
TetrahedralMesh shakenLattice(float most);

/// Eyes from anywhere outside and inside of a box, in planes of the lattice and hardly beside them; by turns in
/// perspective and not.
std::vector<EyePoint> eyesAround(const Eigen::AlignedBox3d& bounds, std::size_t count, std::mt19937& random);

/// Eyes in planes of faces, in lines of edges and at vertices, most of them beside by 1e-9 to 1e-17; by turns in
/// perspective and not.
std::vector<EyePoint> eyesAtFaces(const TetrahedralMesh& mesh, std::size_t count, std::mt19937& random);

/// Faces between two cells: how many have the eye on one side, and of how many the cell on that side does not have the
/// smaller rank. Exact arithmetic, without a tolerance.
struct FacesInOrder {
    std::size_t compared = 0;
    std::size_t wrong = 0;
};
FacesInOrder checkFaces(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency, const EyePoint& eye,
                        std::span<const std::uint32_t> ranks);

} // namespace tetra::testing
