// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rounding.h"
#include "core/data/lattice.h"
#include "core/mesh/topology.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace tetra {

/// Lattice coordinates. A lattice has at most 2^32 points, so every determinant below stays under 2^40 and is exact.
using LatticePoint = std::array<std::int64_t, 3>;
using CellCorners = std::array<LatticePoint, 4>;

constexpr LatticePoint difference(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

constexpr LatticePoint crossProduct(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr std::int64_t dotProduct(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Six times the volume; positive for a positive cell.
constexpr std::int64_t sixVolumes(const CellCorners& c) noexcept
{
    return dotProduct(difference(c[1], c[0]), crossProduct(difference(c[2], c[0]), difference(c[3], c[0])));
}

/// Six volumes times the barycentric coordinates of the points along a row in x: `start` at the row's first point,
/// `step` from one point to the next.
struct BarycentricRow {
    std::array<std::int64_t, 4> start{};
    std::array<std::int64_t, 4> step{};
};

/// The four planes of a cell as integer functions of the place, each zero on one face and sixVolumes() at the corner
/// opposite to it.
class BarycentricPlanes {
public:
    constexpr explicit BarycentricPlanes(const CellCorners& c) noexcept
    {
        for (int corner = 0; corner < 4; ++corner) {
            const auto& [first, second, third] = cornersOfFace[corner];
            const LatticePoint& origin = c[first];
            normals_[corner] = crossProduct(difference(c[third], origin), difference(c[second], origin)); // inwards
            origins_[corner] = origin;
        }
    }

    constexpr BarycentricRow row(const LatticePoint& first) const noexcept
    {
        BarycentricRow row;
        for (int corner = 0; corner < 4; ++corner) {
            row.start[corner] = dotProduct(normals_[corner], difference(first, origins_[corner]));
            row.step[corner] = normals_[corner][0];
        }
        return row;
    }

private:
    std::array<LatticePoint, 4> normals_;
    std::array<LatticePoint, 4> origins_;
};

/// Calls function(place, sample, weights) for every lattice point in the closed cell, row by row: weights are six
/// volumes times its barycentric coordinates, exact. The cell is positive.
template <class Function> void forEachSample(const Lattice& lattice, const CellCorners& corners, Function&& function)
{
    const BarycentricPlanes planes(corners);
    LatticePoint low = corners[0];
    LatticePoint high = corners[0];
    for (const LatticePoint& corner : corners)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], corner[axis]);
            high[axis] = std::max(high[axis], corner[axis]);
        }
    for (std::int64_t k = low[2]; k <= high[2]; ++k)
        for (std::int64_t j = low[1]; j <= high[1]; ++j) {
            const BarycentricRow row = planes.row({low[0], j, k});
            std::array<std::int64_t, 4> weights = row.start;
            std::uint64_t sample = lattice.index(static_cast<std::uint32_t>(low[0]), static_cast<std::uint32_t>(j),
                                                 static_cast<std::uint32_t>(k));
            for (std::int64_t i = low[0]; i <= high[0]; ++i, ++sample) {
                if ((weights[0] | weights[1] | weights[2] | weights[3]) >= 0)
                    function(LatticePoint{i, j, k}, sample, weights);
                for (int corner = 0; corner < 4; ++corner)
                    weights[corner] += row.step[corner];
            }
        }
}

/// Errors of linear interpolation in a cell, comparable with what a model claims. Weights are six volumes times
/// barycentric coordinates.
///
/// Integer samples: everything is a numerator over the cell's six volumes, an integer, and no rounding happens.
/// 8 and 16 bits: below 2^40 * 2^17 * 4, fits 64 bits; 32 bits need 128.
template <class Sample> struct ExactError {
    using Wide = __int128;
    using Number = std::conditional_t<sizeof(Sample) <= 2, std::int64_t, Wide>;

    static Number at(const std::array<std::int64_t, 4>& weights, const std::array<Sample, 4>& corners, Sample sample,
                     std::int64_t /*sixVolumes*/)
    {
        Number sum = 0;
        for (int i = 0; i < 4; ++i)
            sum += static_cast<Number>(weights[i]) * (static_cast<Number>(corners[i]) - static_cast<Number>(sample));
        return sum < 0 ? -sum : sum;
    }

    /// The largest number that is at most `claimed`, in units of the values.
    static Number claimedBound(double claimed, double /*extent*/, std::int64_t sixVolumes)
    {
        constexpr int digits = std::numeric_limits<double>::digits;
        if (!(claimed > 0))
            return 0;
        if (std::isinf(claimed))
            return largest();
        int exponent = 0;
        const double fraction = std::frexp(claimed, &exponent);
        return scaled(static_cast<Wide>(std::ldexp(fraction, digits)) * sixVolumes, exponent - digits);
    }

    /// The largest number that is at most `half` as a fraction of the value range.
    static Number ownBound(std::uint16_t half, double extent, std::int64_t sixVolumes)
    {
        if (half >= 0x7c00)
            return largest();
        const auto fraction = static_cast<std::int64_t>(std::ldexp(halfToFloat(half), 24)); // below 2^40
        return scaled(static_cast<Wide>(fraction) * static_cast<std::int64_t>(extent) * sixVolumes, -24);
    }

    static double inUnitsOfValues(Number error, std::int64_t sixVolumes)
    {
        return static_cast<double>(error) / static_cast<double>(sixVolumes);
    }

private:
    static constexpr Number largest()
    {
        return static_cast<Number>(
            (static_cast<std::conditional_t<sizeof(Number) == 8, std::uint64_t, unsigned __int128>>(0) - 1) / 2);
    }
    /// floor(number * 2^exponent), or the largest Number if that is too large. `number` is below 2^110.
    static Number scaled(Wide number, int exponent)
    {
        if (number <= 0)
            return 0;
        if (exponent < 0)
            number = exponent <= -127 ? 0 : number >> -exponent;
        else if (exponent > 60 || number >> (126 - exponent) != 0)
            return largest();
        else
            number <<= exponent;
        return number > static_cast<Wide>(largest()) ? largest() : static_cast<Number>(number);
    }
};

/// Errors in units of the values, for what no integer holds: floating-point samples and weighted errors (R6). The
/// interpolation and the product with the weight round, in the builder as here, by a few 1e-16 of the range; a claim is
/// kept if it is exceeded by no more than 1e-12 of the range.
template <class Sample> struct RoundedError {
    using Number = double;
    static constexpr double allowance = 1e-12;

    static Number at(const std::array<std::int64_t, 4>& weights, const std::array<Sample, 4>& corners, Sample sample,
                     std::int64_t sixVolumes)
    {
        Number sum = 0;
        for (int i = 0; i < 4; ++i)
            sum += static_cast<double>(weights[i]) / static_cast<double>(sixVolumes) *
                   (static_cast<double>(corners[i]) - static_cast<double>(sample));
        return std::abs(sum);
    }
    static Number claimedBound(double claimed, double extent, std::int64_t /*sixVolumes*/)
    {
        return claimed + allowance * extent;
    }
    static Number ownBound(std::uint16_t half, double extent, std::int64_t /*sixVolumes*/)
    {
        return static_cast<double>(halfToFloat(half)) * extent + allowance * extent;
    }
    static double inUnitsOfValues(Number error, std::int64_t /*sixVolumes*/) { return error; }
};

template <std::floating_point Sample> struct ExactError<Sample> : RoundedError<Sample> {
};

/// The sign of the volume of a tetrahedron, det(b - a, c - a, d - a): 1, 0 or -1, exact for all finite doubles, by
/// CGAL's kernel. For verification: shares nothing with what builds.
int volumeSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);

} // namespace tetra
