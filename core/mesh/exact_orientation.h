// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace tetra {

/// The sign of det(b - a, c - a, d - a): 1, 0 or -1. Exact for all doubles whose triple products neither overflow nor
/// underflow: in doubles where a bound on their rounding allows it, else in integers of 128 bits where the points lie
/// close enough together, else as a sum of doubles that rounds nothing (Shewchuk 1997): a tenth of a microsecond where
/// the normal of a, b and c is one of doubles, a microsecond where the differences of the coordinates are, else
/// some 20.
int orientationSign(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c,
                    const std::array<double, 3>& d);

/// The sign of det(b - a, c - a, direction), that of orientationSign() for a point far away in that direction. As exact
/// and as fast.
int directionSign(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c,
                  const std::array<double, 3>& direction);

} // namespace tetra
