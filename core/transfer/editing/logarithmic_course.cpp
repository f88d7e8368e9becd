// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/editing/logarithmic_course.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Of a step from nothing to full opacity over all positive numbers 1,000 are enough.
constexpr int mostPieces = 1024;

/// The largest distance of a logarithm from its chord over a factor, as a part of its rise.
double largestDeviation(double factor)
{
    const double logarithm = std::log(factor), rise = factor - 1;
    const double there = rise / logarithm;
    return std::max(0.0, std::log(there) / logarithm - (there - 1) / rise);
}

/// The optical depth of a unit distance.
double depthOf(const TransferPoint& point)
{
    return extinctionOf(point.opacity, 1);
}

int piecesBetween(const TransferPoint& from, const TransferPoint& to, const LookTolerance& tolerance)
{
    double change = std::abs(depthOf(to) - depthOf(from)) / tolerance.opacity;
    for (std::size_t channel = 0; channel < 3; ++channel)
        change = std::max(change, std::abs(double{to.colour[channel]} - from.colour[channel]) / tolerance.colour);
    const double logarithm = std::log(to.value / from.value);
    int pieces = 1;
    while (pieces < mostPieces && change / pieces * largestDeviation(std::exp(logarithm / pieces)) > 1)
        ++pieces;
    return pieces;
}

TransferPoint pointBetween(const TransferPoint& from, const TransferPoint& to, double share)
{
    TransferPoint point = from;
    point.value = from.value * std::exp(share * std::log(to.value / from.value));
    for (std::size_t channel = 0; channel < 3; ++channel)
        point.colour[channel] = std::lerp(from.colour[channel], to.colour[channel], static_cast<float>(share));
    point.opacity = static_cast<float>(-std::expm1(-std::lerp(depthOf(from), depthOf(to), share)));
    if (from.group != to.group)
        point.group.reset();
    return point;
}

} // namespace

EditedSelection withLogarithmicCourse(const TransferFunction& function, const TransferSelection& selection,
                                      const LookTolerance& tolerance)
{
    EditedSelection edited{function, {}};
    auto& points = edited.function.points;
    points.clear();
    const auto isSelected = [&](std::size_t point) { return std::ranges::binary_search(selection, point); };
    for (std::size_t i = 0; i < function.points.size(); ++i) {
        const TransferPoint& to = function.points[i];
        if (i > 0 && isSelected(i - 1) && isSelected(i) && function.points[i - 1].value > 0 &&
            function.points[i - 1].value < to.value) {
            const TransferPoint& from = function.points[i - 1];
            const int pieces = piecesBetween(from, to, tolerance);
            for (int piece = 1; piece < pieces; ++piece) {
                const TransferPoint between = pointBetween(from, to, static_cast<double>(piece) / pieces);
                if (between.value <= points.back().value || between.value >= to.value)
                    continue; // nothing lies between numbers that are next to each other
                edited.selection.push_back(points.size());
                points.push_back(between);
            }
        }
        if (isSelected(i))
            edited.selection.push_back(points.size());
        points.push_back(to);
    }
    return edited;
}

} // namespace tetra
