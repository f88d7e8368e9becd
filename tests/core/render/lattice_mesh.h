// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <Eigen/Geometry>

#include <array>
#include <concepts>
#include <cstdint>

namespace tetra::testing {

enum class Split { Five, Six };

/// A conforming mesh of positive tetrahedra over `cells` cubed lattice cubes that fill [0, extent]^3, with the values
/// of `field` at the points. Five tetrahedra a cube, mirrored in every other, or six around the cube's diagonal.
template <std::invocable<const Eigen::Vector3d&> Field>
TetrahedralMesh latticeMesh(std::uint32_t cells, double extent, Split split, Field&& field)
{
    TetrahedralMesh mesh;
    const std::uint32_t size = cells + 1;
    for (std::uint32_t k = 0; k < size; ++k)
        for (std::uint32_t j = 0; j < size; ++j)
            for (std::uint32_t i = 0; i < size; ++i) {
                const Eigen::Vector3d point = Eigen::Vector3d(i, j, k) * (extent / cells);
                mesh.positions.push_back(point);
                mesh.values.push_back(static_cast<float>(field(point)));
            }

    const auto add = [&](std::array<std::uint32_t, 4> t) {
        const auto edge = [&](std::size_t corner) {
            return Eigen::Vector3d(mesh.positions[t[corner]].cast<double>() - mesh.positions[t[0]].cast<double>());
        };
        if (edge(1).dot(edge(2).cross(edge(3))) < 0)
            std::swap(t[2], t[3]);
        mesh.tetrahedra.push_back(t);
    };
    const auto splitCube = [&](const std::array<std::uint32_t, 8>& c, bool mirrored) {
        if (split == Split::Six) {
            for (const auto& [a, b] : {std::array{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}})
                add({c[0], c[std::size_t(a)], c[std::size_t(b)], c[7]});
            return;
        }
        // Corners by the bits of x, y, z; the middle one takes those of even parity, or of odd parity if mirrored.
        const std::size_t flip = mirrored ? 1 : 0;
        add({c[0 ^ flip], c[3 ^ flip], c[5 ^ flip], c[6 ^ flip]});
        for (const std::size_t corner : {1u, 2u, 4u, 7u})
            add({c[corner ^ flip], c[corner ^ 1 ^ flip], c[corner ^ 2 ^ flip], c[corner ^ 4 ^ flip]});
    };
    for (std::uint32_t k = 0; k < cells; ++k)
        for (std::uint32_t j = 0; j < cells; ++j)
            for (std::uint32_t i = 0; i < cells; ++i) {
                std::array<std::uint32_t, 8> corners{};
                for (std::uint32_t bits = 0; bits < 8; ++bits)
                    corners[bits] = ((k + (bits >> 2)) * size + j + (bits >> 1 & 1)) * size + i + (bits & 1);
                splitCube(corners, (i + j + k) % 2 == 1);
            }
    return mesh;
}

} // namespace tetra::testing
