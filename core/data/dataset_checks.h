// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <cstdint>
#include <string>

namespace tetra {

/// What every dataset on a lattice must fulfil, whatever format it comes from. The errors say what is wrong and what to
/// do; the caller names the file.

/// At least two points along each axis, fewer than 2^32, and a number of bytes that fits into 62 bits.
TAN_INTERNAL Status checkLatticeSize(const std::array<std::uint64_t, 3>& size);

/// Positive, finite spacing, finite origin and bounds, and points that stay apart in double precision.
TAN_INTERNAL Status checkLatticePlacement(const Lattice& lattice);

/// Volumes of such coordinates are still numbers.
inline constexpr double farthestCoordinate = 1e90;

/// No NaN, no infinity.
TAN_INTERNAL Status checkFinite(const Lattice& lattice, const ScalarField& values);

/// "32 x 32 x 32".
TAN_INTERNAL std::string sizeText(const std::array<std::uint64_t, 3>& size);

/// How many corners of a grid's cells are positive and negative in physical space: a corner with its three edges, in
/// the order of computational space. The others have no volume.
struct CellCornerSigns {
    std::uint64_t positive = 0;
    std::uint64_t negative = 0;
};

/// For curvilinear datasets; O(points), all threads.
CellCornerSigns cellCornerSigns(const Dataset& dataset);

/// Whether what is positive in the grid's computational space is negative in physical space: more corners of its cells
/// are negative than positive. As cellCornerSigns().
TAN_INTERNAL bool isLeftHanded(const Dataset& dataset);

/// Whether a float holds each coordinate exactly.
TAN_INTERNAL bool fitFloats(const std::vector<Eigen::Vector3d>& positions);

/// What a curvilinear dataset must keep whoever reads it: finite positions and values, and cells with a volume. The
/// error says what is wrong with "it".
TAN_INTERNAL Status checkGrid(const Dataset& dataset);

} // namespace tetra
