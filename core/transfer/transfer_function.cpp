// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace tetra {
namespace {

bool inUnitRange(float number)
{
    return number >= 0 && number <= 1;
}

Error wrongPoint(std::size_t index, const char* what)
{
    return {ErrorKind::BadInput, "Point " + std::to_string(index + 1) + " of the transfer function " + what};
}

TransferSample sampleAt(const TransferFunction& function, const TransferPoint& point)
{
    const auto& [red, green, blue] = point.colour;
    return {{red, green, blue}, extinctionOf(point.opacity, function.unitDistance)};
}

} // namespace

Status checkMask(const TransferMask& mask)
{
    if (!std::isfinite(mask.least) || !std::isfinite(mask.largest) || !(mask.least <= mask.largest))
        return Error{ErrorKind::BadInput, "The mask of a transfer function must be a range of finite values."};
    return {};
}

Status checkTransferFunction(const TransferFunction& function)
{
    if (!(function.unitDistance > 0) || !std::isfinite(function.unitDistance))
        return Error{ErrorKind::BadInput, "The unit distance of a transfer function must be a length above zero."};
    const auto& points = function.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].value))
            return wrongPoint(i, "has no finite value.");
        if (!std::ranges::all_of(points[i].colour, inUnitRange))
            return wrongPoint(i, "has a colour outside 0 to 1.");
        if (!inUnitRange(points[i].opacity))
            return wrongPoint(i, "has an opacity outside 0 to 1.");
        if (points[i].group && (*points[i].group < 0 || *points[i].group > largestTransferGroup))
            return wrongPoint(i, "is of a group that is none of 0 to 9.");
        if (i >= 1 && points[i].value < points[i - 1].value)
            return wrongPoint(i, "has a smaller value than the point before it. Put them in ascending order.");
        if (i >= 2 && points[i].value == points[i - 2].value)
            return wrongPoint(i, "is the third of its value. Two make a step; leave out those between.");
    }
    return function.mask ? checkMask(*function.mask) : Status{};
}

double extinctionOf(double opacity, double unitDistance) noexcept
{
    return -std::log1p(-std::min(opacity, largestOpacity)) / unitDistance;
}

TransferSample evaluate(const TransferFunction& function, double value)
{
    if (const auto& mask = function.mask; mask && !(value >= mask->least && value <= mask->largest))
        return {};
    return evaluateUnmasked(function, value);
}

TransferSample evaluateUnmasked(const TransferFunction& function, double value)
{
    const auto& points = function.points;
    if (points.empty() || std::isnan(value))
        return {};
    const auto above = std::ranges::upper_bound(points, value, {}, &TransferPoint::value);
    if (above == points.begin())
        return sampleAt(function, points.front());
    if (above == points.end())
        return sampleAt(function, points.back());
    const TransferSample low = sampleAt(function, above[-1]);
    const TransferSample high = sampleAt(function, *above);
    const double weight = (value - above[-1].value) / (above->value - above[-1].value);
    TransferSample result;
    for (std::size_t channel = 0; channel < 3; ++channel)
        result.colour[channel] = std::lerp(low.colour[channel], high.colour[channel], weight);
    result.extinction = std::lerp(low.extinction, high.extinction, weight);
    return result;
}

} // namespace tetra
