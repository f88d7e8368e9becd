// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace tetra {

/// The value at `time` of a curve through (times[i], values[i]): once continuously differentiable, between two keys
/// never outside their values, constant where they are equal, at rest before the first key and after the last.
/// `times` rise strictly and are as many as `values`, at least one. O(log keys). (F. N. Fritsch, J. Butland: A method
/// for constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5, 1984.)
double smoothCurveAt(std::span<const double> times, std::span<const double> values, double time);

} // namespace tetra
