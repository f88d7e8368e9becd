// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <optional>
#include <vector>

namespace tetra {

/// A control point of a transfer function.
struct TransferPoint {
    double value = 0;                     ///< of the field
    std::array<float, 3> colour{1, 1, 1}; ///< sRGB, each channel in [0, 1]
    float opacity = 0;                    ///< in [0, 1], of the unit distance
    std::optional<int> group{};           ///< 0 to 9: a label for the editor, which changes nothing of the look
    bool operator==(const TransferPoint&) const = default;
};

/// The values that are shown, [least, largest]: both ends are.
struct TransferMask {
    double least = 0;
    double largest = 0;
    bool operator==(const TransferMask&) const = default;
};

inline constexpr int largestTransferGroup = 9;

/// What a value of the field looks like (R18): colour and extinction, linear between the control points and constant
/// beyond the first and the last. A value with value semantics.
///
/// Points are in ascending order of value. Two points of one value are a step (R22): the first ends what lies below,
/// the second begins what lies above, and the value itself belongs to the upper side, as it does for isosurfaces (S16).
///
/// Opacity is what a layer of `unitDistance` would have if the value did not change in it; the extinction there is
/// -ln(1 - opacity) / unitDistance. It is the extinction that is linear between the points, so that the optical depth
/// of a slab is exact in closed form (S15). An opacity of 1 counts as `largestOpacity`.
struct TransferFunction {
    std::vector<TransferPoint> points;  ///< none: everything is transparent
    double unitDistance = 1;            ///< in the units of the dataset
    std::optional<TransferMask> mask{}; ///< what lies outside of it is transparent, whatever the points say
    bool operator==(const TransferFunction&) const = default;
};

/// Of a unit distance of this opacity one part in 16 million shines through.
inline constexpr double largestOpacity = 1 - 1.0 / (1 << 24);

/// What a place in the field looks like.
struct TransferSample {
    std::array<double, 3> colour{0, 0, 0};
    double extinction = 0; ///< per unit of length of the dataset
};

/// An error if the mask is no range.
Status checkMask(const TransferMask& mask);

/// An error if the points are not in order, more than two have one value, a number is not finite or out of its range,
/// or the mask is no range.
Status checkTransferFunction(const TransferFunction& function);

double extinctionOf(double opacity, double unitDistance) noexcept;

/// O(log points). NaN is transparent.
TransferSample evaluate(const TransferFunction& function, double value);

/// What the points say, whatever the mask: what an editor shows as the curve.
TransferSample evaluateUnmasked(const TransferFunction& function, double value);

/// A range of values, [begin, end), in which colour and extinction are affine:
/// atOrigin + (value - origin) * perValue.
struct TransferSegment {
    double begin = 0; ///< minus infinity for the first
    double end = 0;   ///< infinity for the last
    double origin = 0;
    TransferSample atOrigin;
    TransferSample perValue;

    /// Nothing of these values is seen.
    bool transparent() const noexcept { return atOrigin.extinction == 0 && perValue.extinction == 0; }
};

/// The segments between the knots of a function that checkTransferFunction() accepts, from minus to plus infinity; one
/// transparent segment if it has no points, and one each for what lies to the sides of its mask. O(points).
std::vector<TransferSegment> transferSegments(const TransferFunction& function);

} // namespace tetra
