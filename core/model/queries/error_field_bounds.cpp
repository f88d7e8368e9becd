// SPDX-License-Identifier: GPL-3.0-or-later
// What an error field is at a place, and what it is at least in many. The least numbers hold for what at() returns, not
// only for what it should return: each step of at() is also in doubles a never decreasing, or never increasing,
// function of the distance or of the position between two knots.
#include "core/model/queries/error_field.h"
#include "core/model/queries/field_operations.h"
#include "core/model/queries/region_distance.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tetra {

namespace {

using Node = ErrorField::Node;

constexpr auto valueOf = [](const std::array<double, 2>& knot) { return knot[0]; };
constexpr auto errorOf = [](const std::array<double, 2>& knot) { return knot[1]; };

/// From `first` at 0 to `second` at 1.
double interpolated(double first, double second, double part)
{
    if (!(part > 0)) // also infinity divided by itself
        return first;
    if (part >= 1)
        return second;
    if (std::isinf(first)) // less something infinite it would be no number
        return first;
    return std::clamp(first + (second - first) * part, std::min(first, second), std::max(first, second));
}

double atDistance(const SpaceRamp& ramp, double distance)
{
    if (ramp.falloff > 0)
        return interpolated(ramp.inner, ramp.outer, distance / ramp.falloff);
    return distance > 0 ? ramp.outer : ramp.inner;
}

double leastOf(const SpaceRamp& ramp)
{
    return std::min(ramp.inner, ramp.outer);
}
double largestOf(const SpaceRamp& ramp)
{
    return std::max(ramp.inner, ramp.outer);
}

double leastOf(const ValueRamp& ramp)
{
    return ramp.knots.empty() ? 0 : std::ranges::min(ramp.knots, {}, errorOf)[1];
}

double largestOf(const ValueRamp& ramp)
{
    return ramp.knots.empty() ? 0 : std::ranges::max(ramp.knots, {}, errorOf)[1];
}

double at(const ValueRamp& ramp, double value)
{
    if (std::isnan(value))
        return leastOf(ramp);
    const auto first = std::ranges::lower_bound(ramp.knots, value, {}, valueOf);
    const auto last = std::ranges::upper_bound(first, ramp.knots.end(), value, {}, valueOf);
    if (first != last)
        return errorOf(*std::ranges::min_element(first, last, {}, errorOf));
    if (first == ramp.knots.begin())
        return first == ramp.knots.end() ? 0 : errorOf(*first);
    const auto& [valueBefore, errorBefore] = *(first - 1);
    if (first == ramp.knots.end())
        return errorBefore;
    return interpolated(errorBefore, errorOf(*first), (value - valueBefore) / (valueOf(*first) - valueBefore));
}

double leastOf(const ValueRamp& ramp, const ValueRange& values)
{
    if (!(values.minimum <= values.maximum))
        return leastOf(ramp);
    double found = std::min(at(ramp, values.minimum), at(ramp, values.maximum));
    for (auto knot = std::ranges::lower_bound(ramp.knots, values.minimum, {}, valueOf);
         knot != ramp.knots.end() && valueOf(*knot) <= values.maximum; ++knot)
        found = std::min(found, errorOf(*knot));
    return found;
}

double leastOf(const SpaceRamp& ramp, const Hull& hull)
{
    if (!hull.finite)
        return leastOf(ramp);
    if (ramp.inner > ramp.outer)
        return atDistance(ramp, farthestDistance(ramp.region, hull));
    if (ramp.falloff > 0)
        return atDistance(ramp, nearestDistance(ramp.region, hull));
    return meets(ramp.region, hull) ? ramp.inner : ramp.outer;
}

/// The box around the hull is found when a ramp asks for it.
class Least {
public:
    Least(const Corners& corners, double margin, const ValueRange& values)
        : corners_(corners), margin_(margin), values_(values)
    {
    }

    double of(const Node& node)
    {
        if (const double* const number = std::get_if<double>(&node.content))
            return *number;
        if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&node.content)) {
            if (!hull_)
                hull_.emplace(corners_, margin_);
            return leastOf(*ramp, *hull_);
        }
        if (const ValueRamp* const ramp = std::get_if<ValueRamp>(&node.content))
            return leastOf(*ramp, values_);
        const Node::Pair& pair = *std::get_if<Node::Pair>(&node.content);
        return applied(pair.operation, of(pair.first.root()), of(pair.second.root()));
    }

private:
    const Corners& corners_;
    double margin_;
    const ValueRange& values_;
    std::optional<Hull> hull_;
};

ValueRange boundsOf(const Node& node)
{
    if (const auto* const pair = std::get_if<Node::Pair>(&node.content)) {
        const ValueRange first = pair->first.bounds();
        const ValueRange second = pair->second.bounds();
        return {applied(pair->operation, first.minimum, second.minimum),
                applied(pair->operation, first.maximum, second.maximum)};
    }
    if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&node.content))
        return {leastOf(*ramp), largestOf(*ramp)};
    if (const ValueRamp* const ramp = std::get_if<ValueRamp>(&node.content))
        return {leastOf(*ramp), largestOf(*ramp)};
    const double number = *std::get_if<double>(&node.content);
    return {number, number};
}

double evaluated(const Node& node, const Eigen::Vector3d& place, double value)
{
    if (const double* const number = std::get_if<double>(&node.content))
        return *number;
    if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&node.content))
        return atDistance(*ramp, distanceTo(ramp->region, place));
    if (const ValueRamp* const ramp = std::get_if<ValueRamp>(&node.content))
        return at(*ramp, value);
    const Node::Pair& pair = *std::get_if<Node::Pair>(&node.content);
    return applied(pair.operation, evaluated(pair.first.root(), place, value),
                   evaluated(pair.second.root(), place, value));
}

} // namespace

double ErrorField::at(const Eigen::Vector3d& place, double value) const
{
    return evaluated(*root_, place, value);
}

ValueRange ErrorField::bounds() const
{
    return boundsOf(*root_);
}

double ErrorField::leastIn(const std::array<Eigen::Vector3d, 4>& corners, double margin, const ValueRange& values) const
{
    if (const double* const number = std::get_if<double>(&root_->content))
        return *number;
    if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&root_->content))
        return leastOf(*ramp, Hull(corners, margin));
    return Least(corners, margin, values).of(*root_);
}

} // namespace tetra
