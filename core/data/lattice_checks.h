// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/data/dataset.h"

#include <array>
#include <cstdint>
#include <string>

namespace tetra {

/// What every dataset on a lattice must fulfil, whatever format it comes from. The errors say what is wrong and what to
/// do; the caller names the file.

/// At least two points along each axis, fewer than 2^32, and a number of bytes that fits into 62 bits.
Status checkLatticeSize(const std::array<std::uint64_t, 3>& size);

/// Positive, finite spacing, finite origin and bounds, and points that stay apart in double precision.
Status checkLatticePlacement(const Lattice& lattice);

/// No NaN, no infinity.
Status checkFinite(const Lattice& lattice, const ScalarField& values);

/// "32 x 32 x 32".
std::string sizeText(const std::array<std::uint64_t, 3>& size);

} // namespace tetra
