// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/animation/smooth_curve.h"

#include <algorithm>
#include <cstddef>

namespace tetra {
namespace {

double slope(std::span<const double> times, std::span<const double> values, std::size_t i)
{
    return (values[i + 1] - values[i]) / (times[i + 1] - times[i]);
}

/// The weighted harmonic mean of the slopes on both sides, and none at an extremum: so the curve stays between its
/// keys. None at the ends, either: a film begins and ends at rest.
double tangentAt(std::span<const double> times, std::span<const double> values, std::size_t i)
{
    if (i == 0 || i + 1 == times.size())
        return 0;
    const double before = slope(times, values, i - 1);
    const double after = slope(times, values, i);
    if (!(before * after > 0))
        return 0;
    const double first = times[i] - times[i - 1];
    const double second = times[i + 1] - times[i];
    return 3 * (first + second) / ((2 * second + first) / before + (second + 2 * first) / after);
}

} // namespace

double smoothCurveAt(std::span<const double> times, std::span<const double> values, double time)
{
    if (!(time > times.front()))
        return values.front();
    if (time >= times.back())
        return values.back();
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
    const std::size_t last = next - 1;
    const double length = times[next] - times[last];
    const double part = (time - times[last]) / length;
    const double rest = 1 - part;
    // Hermite's form.
    const double value =
        values[last] * (1 + 2 * part) * rest * rest + values[next] * (3 - 2 * part) * part * part +
        length * part * rest * (tangentAt(times, values, last) * rest - tangentAt(times, values, next) * part);
    const auto [least, largest] = std::minmax(values[last], values[next]);
    return std::clamp(value, least, largest); // rounding may leave them
}

} // namespace tetra
