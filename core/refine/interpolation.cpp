// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/interpolation.h"

#include "core/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tetra {

namespace {

/// 113 bits: differences of coordinates become exact, and what cancels in thin cells has 60 bits to spare.
__extension__ using Quadruple = __float128;

template <class Real> Real absolute(Real number)
{
    return number < 0 ? -number : number;
}

/// A number and the sum of its terms' magnitudes, which its rounding error is a few units in the last place of.
template <class Real> struct Sum {
    Real value = 0;
    Real magnitude = 0;
};

template <class Real> using Vector = std::array<Real, 3>;

template <class Real> Sum<Real> determinant(const Vector<Real>& a, const Vector<Real>& b, const Vector<Real>& c)
{
    Sum<Real> sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const Real first = b[j] * c[k], second = b[k] * c[j];
        sum.value += a[i] * (first - second);
        sum.magnitude += absolute(a[i]) * (absolute(first) + absolute(second));
    }
    return sum;
}

/// The error, and how much of it may be rounding. The position's four sub-volumes are weights without a common sign to
/// cancel, so only what cancels inside each of them matters.
template <class Real>
Sum<Real> errorIn(const InterpolatingCell& cell, const Eigen::Vector3d& position, double value, Real epsilon)
{
    std::array<Vector<Real>, 4> to;
    for (std::size_t corner = 0; corner < 4; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            to[corner][static_cast<std::size_t>(axis)] =
                static_cast<Real>(cell.corners[corner][axis]) - static_cast<Real>(position[axis]);
    Real volume = 0, difference = 0, doubt = 0, largest = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto& [a, b, c] = cornersOfFace[corner];
        const Sum<Real> weight = determinant(to[a], to[b], to[c]);
        const Real step = static_cast<Real>(cell.values[corner]) - static_cast<Real>(value);
        volume += weight.value;
        difference += weight.value * step;
        doubt += weight.magnitude;
        largest = std::max(largest, absolute(step));
    }
    constexpr int roundings = 16;
    const Real size = absolute(volume);
    return {absolute(difference) / size, roundings * epsilon * doubt / size * 2 * largest};
}

double trusted(double error, double doubt)
{
    return error > doubt ? error : 0;
}

} // namespace

double interpolationError(const InterpolatingCell& cell, const Eigen::Vector3d& position, double value)
{
    constexpr double tolerance = 1e-13;
    double largest = 0;
    for (const double corner : cell.values)
        largest = std::max(largest, std::abs(corner - value));
    if (largest == 0)
        return 0;
    const Sum<double> quick = errorIn<double>(cell, position, value, 0x1p-53);
    if (quick.magnitude <= tolerance * largest)
        return trusted(quick.value, quick.magnitude);
    const Sum<Quadruple> exact = errorIn<Quadruple>(cell, position, value, static_cast<Quadruple>(0x1p-113));
    return trusted(static_cast<double>(exact.value), static_cast<double>(exact.magnitude));
}

} // namespace tetra
