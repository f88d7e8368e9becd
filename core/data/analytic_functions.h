// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace tetra {

/// Evaluates a field along one row of a cube of size^3 points, all i at (j, k): row[i] in [0, 1]. Called from many
/// threads. The cube's points are the regular ones of [-1, 1]^3, its corners included: u = 2 i / (size - 1) - 1.
using RowFunction = std::function<void(std::uint32_t j, std::uint32_t k, std::span<double> row)>;

/// Electron density of the C60 molecule, after the model of independent atoms: the sum over the 60 corners p of a
/// truncated icosahedron with edges of 1.43 Angstrom (the mean of the molecule's bond lengths, 1.40 and 1.45) of
/// exp(-|x - p|^2 / (2 w^2)), w = 0.62 Angstrom, divided by its largest value. The cube reaches 4.7 Angstrom from the
/// centre along each axis. Smooth, with a hollow inside: the stand-in for the literature's Bucky Ball at any size.
RowFunction c60Density(std::uint32_t size);

/// Probability density of the hydrogen atom's 3d electron with m = 0: |psi|^2 over its largest value,
/// ((3 z^2 - r^2) / 72)^2 exp(4 - 2 r / 3), lengths in Bohr radii, which the cube holds 20 of from its centre along
/// each axis. (The wave function is in every text on quantum mechanics, e.g. Griffiths, section 4.2.)
RowFunction hydrogenDensity(std::uint32_t size);

/// The test signal of S. Marschner and R. Lobb, "An evaluation of reconstruction filters for volume rendering", IEEE
/// Visualization 1994: (1 - sin(pi z / 2) + a (1 + cos(2 pi f cos(pi r / 2)))) / (2 (1 + a)), r = sqrt(x^2 + y^2), with
/// f = 6 and a = 0.25. Its ripples near the Nyquist limit of 40^3 points are hard to reproduce.
RowFunction marschnerLobbSignal(std::uint32_t size);

/// White noise: sample n is the top 53 bits of the n-th number of SplitMix64 (Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014) from `seed`. No sample tells of its neighbour: the worst case.
RowFunction whiteNoise(std::uint32_t size, std::uint64_t seed);

} // namespace tetra
