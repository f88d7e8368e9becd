// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tetra {

/// Functions whose results are the same bits on every machine with IEEE arithmetic, which those of the C library are
/// not: only + - * and roundings, no contraction. Correct to a few units in the last place.

/// e^x for finite x in [-700, 700]; clamped beyond, which is next to nothing or next to infinity.
double portableExponential(double x) noexcept;

/// cos(2 pi turns), for |turns| up to 2^52.
double portableCosineOfTurns(double turns) noexcept;

} // namespace tetra
