// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/render/lattice_mesh.h"

#include <tan/mesh.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tetra::testing {

/// A cube of side 2 with holes, cavities and loose pieces: the cells that lie in random balls are taken out. What is
/// left may touch itself at edges and vertices, as data do that are no manifold.
inline TetrahedralMesh holedMesh(unsigned seed, std::uint32_t cells = 7)
{
    TetrahedralMesh mesh = latticeMesh(cells, 2, seed % 2 == 0 ? Split::Five : Split::Six,
                                       [](const Eigen::Vector3d& p) { return std::sin(3 * p.x()) + p.y() * p.z(); });
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-0.2f, 2.2f), size(0.2f, 0.6f);
    for (int hole = 0; hole < 8; ++hole) {
        const Eigen::Vector3d centre(place(random), place(random), place(random));
        const float radius = size(random);
        std::erase_if(mesh.tetrahedra, [&](const auto& t) {
            const Eigen::Vector3d middle =
                (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]] + mesh.positions[t[3]]) / 4;
            return (middle - centre).norm() < radius;
        });
    }
    return mesh;
}

} // namespace tetra::testing
