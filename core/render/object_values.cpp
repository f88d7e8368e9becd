// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/object_values.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double besideBackground = 1.0 / 30; ///< of the range
constexpr double hardlySeen = 0.1;            ///< of the largest extinction
constexpr int looks = 128;                    ///< at values of a range

double mostExtinction(const TransferFunction& function)
{
    double most = 0;
    for (const OpacityPoint& point : function.opacities)
        most = std::max(most, evaluate(function, point.value).extinction);
    return most;
}

/// Whether `holds` for some values from one to the other, with both.
template <class Holds> bool allOf(double from, double to, Holds holds)
{
    for (int look = 0; look <= looks; ++look)
        if (!holds(std::lerp(from, to, static_cast<double>(look) / looks)))
            return false;
    return true;
}

} // namespace

ObjectValues::ObjectValues(const ValueHistogram& volumes, std::optional<double> surface)
    : background_(backgroundValues(volumes)), surface_(surface), least_(volumes.least), largest_(volumes.largest),
      beside_(besideBackground * (volumes.largest - volumes.least))
{
    if (!background_)
        return;
    function_ = fittedTransferFunction(volumes, 1);
    most_ = mostExtinction(function_);
}

bool ObjectValues::has(double value) const
{
    if (!background_)
        return true;
    if (surface_ && (background_->commonest < *surface_ ? value >= *surface_ : value <= *surface_))
        return true;
    return (value < background_->least - beside_ || value > background_->largest + beside_) &&
           evaluate(function_, value).extinction > hardlySeen * most_;
}

bool ObjectValues::hasAllBeyond(double isovalue) const
{
    return !background_ || allOf(isovalue, isovalue > background_->commonest ? largest_ : least_,
                                 [this](double value) { return has(value); });
}

bool ObjectValues::hasAllSeenOf(const TransferFunction& function) const
{
    constexpr double alike = 1.01;
    const double most = mostExtinction(function);
    return !background_ || allOf(least_, largest_, [&](double value) {
        const double extinction = evaluate(function, value).extinction;
        const double usual = evaluate(function_, value).extinction / function.unitDistance; // that of function_ is 1
        return has(value) || extinction <= hardlySeen * most || extinction <= alike * usual;
    });
}

} // namespace tetra
