// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/decimation.h"
#include "core/decimate/lattice_tetrahedra.h"

#include "tests/core/decimate/tetrahedra_topology.h"

#include <cmath>
#include <random>

namespace tetra {

/// What a DecimationMesh refers to.
struct TestMesh {
    std::vector<Eigen::Vector3d> positions;
    std::vector<Eigen::Vector3d> physical;
    std::vector<double> values;
    std::vector<float> weights;
    TestTetrahedra tetrahedra;
    bool box = false;

    DecimationMesh view() const { return {positions, physical, values, weights, tetrahedra, box}; }
};

/// A lattice with a smooth field and a little noise.
inline TestMesh latticeMesh(const std::array<std::uint32_t, 3>& size, LatticeCut cut, std::uint32_t seed)
{
    TestMesh mesh;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double phase = uniform(random);
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                mesh.positions.emplace_back(x, y, z);
                mesh.values.push_back(std::sin(.7 * x + phase) + std::cos(.5 * y - .3 * z) + .1 * uniform(random));
            }
    mesh.tetrahedra = latticeTetrahedra(size, cut);
    mesh.box = true;
    return mesh;
}

/// Cells of a lattice, some left out so that there are holes, cavities and several parts, with a closed surface as
/// their boundary, and every point moved by up to `jitter` of the spacing along each axis.
inline TestMesh nonconvexMesh(std::uint32_t seed, double jitter)
{
    std::mt19937 random(seed);
    const auto upTo = [&random](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
    const std::array<std::uint32_t, 3> size{4 + upTo(3), 4 + upTo(2), 4 + upTo(2)};
    const auto cut = LatticeCut::Five;
    const TestMesh lattice = latticeMesh(size, cut, seed);
    const std::uint32_t cells = static_cast<std::uint32_t>(lattice.tetrahedra.size() / 5);
    std::vector<bool> kept(cells, true);
    if (upTo(2) == 0) // a gap, so that there are two parts
        for (std::uint32_t cell = 0; cell < cells; ++cell)
            kept[cell] = cell % (size[0] - 1) != 1;
    const auto tetrahedra = [&] {
        TestTetrahedra result;
        for (std::uint32_t cell = 0; cell < cells; ++cell)
            if (kept[cell])
                result.insert(result.end(), lattice.tetrahedra.begin() + 5 * cell,
                              lattice.tetrahedra.begin() + 5 * cell + 5);
        return result;
    };
    for (std::uint32_t attempts = upTo(cells / 2); attempts > 0; --attempts) {
        const std::uint32_t cell = upTo(cells);
        if (!kept[cell])
            continue;
        kept[cell] = false;
        const TestTetrahedra without = tetrahedra();
        if (without.empty() || !topologyOf(without).fault.empty())
            kept[cell] = true;
    }
    TestMesh mesh;
    std::map<std::uint32_t, std::uint32_t> number;
    std::uniform_real_distribution<double> moved(-jitter, jitter);
    for (auto tetrahedron : tetrahedra()) {
        for (std::uint32_t& vertex : tetrahedron) {
            const auto [found, isNew] = number.try_emplace(vertex, static_cast<std::uint32_t>(mesh.positions.size()));
            if (isNew) {
                mesh.positions.push_back(lattice.positions[vertex] +
                                         Eigen::Vector3d(moved(random), moved(random), moved(random)));
                mesh.values.push_back(lattice.values[vertex]);
            }
            vertex = found->second;
        }
        mesh.tetrahedra.push_back(tetrahedron);
    }
    return mesh;
}

} // namespace tetra
