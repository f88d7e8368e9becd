// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/editing/whole_function.h"

#include <cmath>

namespace tetra {
namespace {

/// With all values elsewhere; as it was if that is no function. The order of values must stay.
template <class Where> TransferFunction moved(const TransferFunction& function, const Where& where)
{
    TransferFunction edited{{}, function.unitDistance};
    auto& points = edited.points;
    for (TransferPoint point : function.points) {
        point.value = where(point.value);
        const auto count = points.size();
        if (count >= 2 && points[count - 1].value == point.value && points[count - 2].value == point.value)
            points.pop_back();
        points.push_back(point);
    }
    if (const auto& mask = function.mask)
        edited.mask = {where(mask->least), where(mask->largest)};
    return checkTransferFunction(edited) ? edited : function;
}

} // namespace

TransferFunction shifted(const TransferFunction& function, double by)
{
    return moved(function, [by](double value) { return value + by; });
}

TransferFunction widened(const TransferFunction& function, double centre, double factor)
{
    if (!(factor > 0) || !std::isfinite(factor) || !std::isfinite(centre))
        return function;
    return moved(function, [=](double value) { return centre + (value - centre) * factor; });
}

TransferFunction withMask(const TransferFunction& function, const TransferMask& mask)
{
    TransferFunction edited = function;
    if (checkMask(mask))
        edited.mask = mask;
    return edited;
}

TransferFunction withoutMask(const TransferFunction& function)
{
    TransferFunction edited = function;
    edited.mask.reset();
    return edited;
}

} // namespace tetra
