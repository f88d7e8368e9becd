// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>
#include <tan/transfer.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tetra::testing {

/// Meshes and transfer functions that the volume's tests draw, values about in [0, 1].
struct NamedMesh {
    std::string name;
    TetrahedralMesh mesh;
};
struct NamedFunction {
    std::string name;
    TransferFunction function;
    bool opaque = false; ///< has parts that let nothing through
};

TetrahedralMesh oneCell();
/// A lattice of jittered points with a tunnel through it and a part of its own: the domain is not convex.
TetrahedralMesh irregularWithHole();
/// What a refined lattice of smooth bumps looks like when it is extracted at one percent, and a bent grid likewise.
TetrahedralMesh refinedLattice();
TetrahedralMesh refinedBentGrid();
/// The lattice refined in blocks, and at an accuracy that falls off from a corner.
TetrahedralMesh refinedInBlocks();
TetrahedralMesh variableResolution();
/// Random points and values, the lattice's own Delaunay mesh with its many cospherical points.
TetrahedralMesh randomLattice(std::uint32_t seed);

/// Three sticks, each with one end before the next: seen along y from the front none of them comes first.
TetrahedralMesh threeSticks();
/// Needles that lie about at random without touching: they hide each other in circles from most sides.
TetrahedralMesh needles(int count, std::uint32_t seed);

std::vector<NamedMesh> volumeMeshes();
/// For values in [smallest, largest]: ramps, steps, spikes, and one that is opaque.
std::vector<NamedFunction> volumeFunctions(double smallest, double largest, double unitDistance);

} // namespace tetra::testing
