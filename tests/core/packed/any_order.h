// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// A corner as bits, and a tetrahedron with what belongs to it.
using CornerBits = std::array<std::uint64_t, 4>;
struct TetrahedronBits {
    std::array<CornerBits, 4> corners;
    std::array<std::uint32_t, 2> life{};
    auto operator<=>(const TetrahedronBits&) const = default;
};

inline CornerBits bitsOf(const TetrahedralMesh& mesh, std::uint32_t vertex)
{
    const Eigen::Vector3d& position = mesh.positions[vertex];
    return {std::bit_cast<std::uint64_t>(position[0]), std::bit_cast<std::uint64_t>(position[1]),
            std::bit_cast<std::uint64_t>(position[2]), std::bit_cast<std::uint32_t>(mesh.values[vertex])};
}

/// The mesh whatever the order of its vertices, its tetrahedra and, but for the sign, their corners.
inline std::pair<std::vector<CornerBits>, std::vector<TetrahedronBits>>
inAnyOrder(const TetrahedralMesh& mesh, std::span<const float> births, std::span<const float> deaths)
{
    std::vector<CornerBits> vertices;
    for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex)
        vertices.push_back(bitsOf(mesh, vertex));
    std::ranges::sort(vertices);
    std::vector<TetrahedronBits> tetrahedra;
    for (std::size_t cell = 0; cell < mesh.tetrahedra.size(); ++cell) {
        TetrahedronBits bits;
        for (std::size_t i = 0; i < 4; ++i)
            bits.corners[i] = bitsOf(mesh, mesh.tetrahedra[cell][i]);
        bool odd = false, alike = false;
        for (int round = 0; round < 4; ++round)
            for (std::size_t i = 0; i < 3; ++i)
                if (bits.corners[i + 1] < bits.corners[i]) {
                    std::swap(bits.corners[i], bits.corners[i + 1]);
                    odd = !odd;
                }
        for (std::size_t i = 0; i < 3; ++i)
            alike = alike || bits.corners[i] == bits.corners[i + 1];
        if (odd && !alike)
            std::swap(bits.corners[2], bits.corners[3]);
        if (!births.empty())
            bits.life = {std::bit_cast<std::uint32_t>(births[cell]), std::bit_cast<std::uint32_t>(deaths[cell])};
        tetrahedra.push_back(bits);
    }
    std::ranges::sort(tetrahedra);
    return {vertices, tetrahedra};
}

} // namespace tetra
