// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace tetra {

/// The weights of a triangle's corners whose mean is nearest to the origin (Ericson, Real-Time Collision
/// Detection, 5.1.5).
std::array<double, 3> nearestWeights(const std::array<std::array<double, 3>, 3>& corners);

} // namespace tetra
