// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/import/curves.h"

#include "core/base/text.h"

#include <tan/transfer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace tetra {

namespace {

/// How many times a stretch may be halved.
constexpr int deepestHalving = 12;

/// Places inside a stretch at which it is compared.
constexpr int placesCompared = 8;

/// Shares of the way from 0 to 1, both included and ascending, between which a curve may be replaced by whatever
/// `matches` compares it with: stretches are halved until matches(from, to, place) holds at places inside, or they are
/// very short.
template <class Matches> std::vector<double> adaptivePoints(const Matches& matches)
{
    std::vector<double> points{0};
    const auto divide = [&](const auto& self, double from, double to, int depth) -> void {
        bool good = true;
        for (int place = 1; good && place <= placesCompared; ++place)
            good = matches(from, to, std::lerp(from, to, place / (placesCompared + 1.0)));
        if (good || depth == deepestHalving) {
            points.push_back(to);
            return;
        }
        const double middle = std::midpoint(from, to);
        self(self, from, middle, depth + 1);
        self(self, middle, to, depth + 1);
    };
    divide(divide, 0, 1, 0);
    return points;
}

constexpr double tolerance = 1.0 / 1000;

/// How far a value is from one node toward the next, both at different values.
double shareOf(double value, double from, double to, bool logarithmic)
{
    if (logarithmic)
        return std::log(value / from) / std::log(to / from);
    return (value - from) / (to - from);
}

/// The first node beyond the value: what lies between it and the one before is the value's stretch.
template <class Node> std::size_t nodeBeyond(std::span<const Node> nodes, double value)
{
    return static_cast<std::size_t>(std::ranges::upper_bound(nodes, value, {}, &Node::value) - nodes.begin());
}

SrgbColour curveColourAt(const ColourCurve& curve, double value)
{
    const std::size_t beyond = nodeBeyond(std::span(curve.nodes), value);
    if (beyond == 0 || beyond == curve.nodes.size())
        return (beyond == 0 ? curve.nodes.front() : curve.nodes.back()).colour;
    const ColourNode &from = curve.nodes[beyond - 1], &to = curve.nodes[beyond];
    return between(from.colour, to.colour, shareOf(value, from.value, to.value, curve.logarithmic), curve.space);
}

/// VTK's way from one opacity to the next: a line, a step, or with a sharpness in between a Hermite curve through the
/// midpoint.
double opacityBetween(const OpacityNode& from, double to, double s)
{
    const double middle = std::clamp(from.midpoint, 1e-5, 1 - 1e-5);
    s = s < middle ? 0.5 * s / middle : 0.5 + 0.5 * (s - middle) / (1 - middle);
    if (from.sharpness > 0.99)
        return s < 0.5 ? from.opacity : to;
    if (from.sharpness < 0.01)
        return std::lerp(from.opacity, to, s);
    const double power = 1 + 10 * from.sharpness;
    s = s < 0.5 ? 0.5 * std::pow(2 * s, power) : 1 - 0.5 * std::pow(2 * (1 - s), power);
    const double square = s * s, cube = square * s;
    const double slope = (1 - from.sharpness) * (to - from.opacity);
    const double opacity = (2 * cube - 3 * square + 1) * from.opacity + (3 * square - 2 * cube) * to +
                           (cube - 2 * square + s) * slope + (cube - square) * slope;
    return std::clamp(opacity, std::min(from.opacity, to), std::max(from.opacity, to));
}

double opacityAt(std::span<const OpacityNode> nodes, double value)
{
    const std::size_t beyond = nodeBeyond(nodes, value);
    if (beyond == 0 || beyond == nodes.size())
        return (beyond == 0 ? nodes.front() : nodes.back()).opacity;
    const OpacityNode &from = nodes[beyond - 1], &to = nodes[beyond];
    return opacityBetween(from, to.opacity, shareOf(value, from.value, to.value, false));
}

/// What a value looks like, as files say it; masks are no part of it.
struct Look {
    SrgbColour colour{};
    double opacity = 0;
};

Look lookOf(const TransferFunction& function, double value)
{
    const TransferSample sample = evaluateUnmasked(function, value);
    return {sample.colour, -std::expm1(-sample.extinction * function.unitDistance)};
}

Look lookOf(const CurvePreset& preset, const TransferFunction& present, double value)
{
    Look look = lookOf(present, value);
    if (!preset.colours.nodes.empty())
        look.colour = curveColourAt(preset.colours, value);
    if (!preset.opacities.empty())
        look.opacity = opacityAt(preset.opacities, value);
    return look;
}

bool nearlySame(const Look& left, const Look& right)
{
    for (std::size_t channel = 0; channel < left.colour.size(); ++channel)
        if (!(std::abs(left.colour[channel] - right.colour[channel]) <= tolerance))
            return false;
    return std::abs(left.opacity - right.opacity) <= tolerance;
}

TransferPoint pointOf(double value, const Look& look)
{
    TransferPoint point;
    point.value = value;
    for (std::size_t channel = 0; channel < 3; ++channel)
        point.colour[channel] = static_cast<float>(std::clamp(look.colour[channel], 0.0, 1.0));
    point.opacity = static_cast<float>(std::clamp(look.opacity, 0.0, 1.0));
    return point;
}

/// Whether two points are one but for rounding: no step.
bool same(const TransferPoint& left, const TransferPoint& right)
{
    const auto close = [](float a, float b) { return std::abs(a - b) <= 1e-6f; };
    return left.value == right.value && close(left.opacity, right.opacity) &&
           std::ranges::equal(left.colour, right.colour, close);
}

/// Where either curve has a node, each value once.
std::vector<double> valuesOfNodes(const CurvePreset& preset, const TransferFunction& present)
{
    std::vector<double> values;
    for (const ColourNode& node : preset.colours.nodes)
        values.push_back(node.value);
    for (const OpacityNode& node : preset.opacities)
        values.push_back(node.value);
    if (preset.colours.nodes.empty() || preset.opacities.empty())
        for (const TransferPoint& point : present.points)
            values.push_back(point.value);
    // A sharp opacity steps at its midpoint.
    for (std::size_t node = 0; node + 1 < preset.opacities.size(); ++node)
        if (preset.opacities[node].sharpness > 0.99)
            values.push_back(std::lerp(preset.opacities[node].value, preset.opacities[node + 1].value,
                                       preset.opacities[node].midpoint));
    std::ranges::sort(values);
    values.erase(std::ranges::unique(values).begin(), values.end());
    return values;
}

} // namespace

TransferFunction transferFunctionOf(const CurvePreset& preset, const TransferFunction& present)
{
    TransferFunction function;
    function.unitDistance = present.unitDistance;
    if (preset.opacities.empty())
        function.mask = present.mask;
    const std::vector<double> values = valuesOfNodes(preset, present);
    const auto look = [&](double value) { return lookOf(preset, present, value); };
    const auto add = [&function](const TransferPoint& point) {
        if (function.points.empty() || !same(function.points.back(), point))
            function.points.push_back(point);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // So near each other are the sides of a step, as ParaView has it.
    const double narrow = values.empty() ? 0 : 2e-9 * (values.back() - values.front());
    if (!values.empty())
        add(pointOf(values.front(), look(std::nextafter(values.front(), -infinity))));
    for (std::size_t stretch = 0; stretch + 1 < values.size(); ++stretch) {
        const double from = values[stretch], to = values[stretch + 1];
        // Just inside: at the ends themselves the curves may step.
        const double first = std::nextafter(from, to), last = std::nextafter(to, from);
        const auto pointAt = [&](double share) {
            const double value = share <= 0 ? from : share >= 1 ? to : std::lerp(from, to, share);
            return pointOf(value, look(std::clamp(value, first, last)));
        };
        if (to - from <= narrow) {
            add(pointAt(0));
            auto& points = function.points;
            // The upper side of a step stays where it is.
            if (points.size() > 1 && points[points.size() - 2].value == from)
                points.push_back(points.back());
            points.back().value = to;
            continue;
        }
        const auto matches = [&](double a, double b, double place) {
            const TransferFunction straight{{pointAt(a), pointAt(b)}, function.unitDistance};
            const double value = std::lerp(from, to, place);
            return nearlySame(lookOf(straight, value), look(std::clamp(value, first, last)));
        };
        for (const double share : adaptivePoints(matches))
            add(pointAt(share));
    }
    if (!values.empty())
        add(pointOf(values.back(), look(std::nextafter(values.back(), infinity))));
    return function;
}

namespace {

TransferFunction withPointAt(const TransferFunction& function, double value)
{
    const auto has = std::ranges::find(function.points, value, &TransferPoint::value) != function.points.end();
    const auto added = has ? std::nullopt : withPoint(function, value);
    return added ? added->function : function;
}

TransferPoint transparent(TransferPoint point, double value)
{
    point.value = value;
    point.opacity = 0;
    return point;
}

/// The least distance of two values of the function that ParaView keeps in order: a billionth of the range.
double leastApart(const TransferFunction& function)
{
    if (function.points.empty())
        return 0;
    const double first = function.points.front().value, last = function.points.back().value;
    return 1e-9 * (last > first ? last - first : std::max(1.0, std::abs(first)));
}

/// A function without a mask that looks as the one with it: what the mask hides has points of opacity 0. The mask's
/// largest value is still seen, so the step there is leastApart() above it.
TransferFunction withMaskAsSteps(const TransferFunction& function)
{
    if (!function.mask || function.points.empty())
        return {function.points, function.unitDistance};
    const TransferMask mask = *function.mask;
    TransferFunction steps = withPointAt(withPointAt(function, mask.least), mask.largest);
    steps.mask.reset();
    auto& points = steps.points;
    const double apart = leastApart(steps);

    const auto above = std::ranges::upper_bound(points, mask.largest, {}, &TransferPoint::value);
    for (auto point = above; point != points.end(); ++point)
        point->opacity = 0;
    double hidden = mask.largest + apart;
    if (above != points.end())
        hidden = std::min(hidden, std::midpoint(mask.largest, above->value));
    points.insert(above, transparent(above[-1], hidden));

    const auto first = std::ranges::lower_bound(points, mask.least, {}, &TransferPoint::value);
    for (auto point = points.begin(); point != first; ++point)
        point->opacity = 0;
    if (std::ranges::count(points, mask.least, &TransferPoint::value) > 1)
        first->opacity = 0;
    else
        points.insert(first, transparent(*first, mask.least));
    return steps;
}

} // namespace

CurvePreset curvesOf(const TransferFunction& masked, const std::string& name)
{
    const TransferFunction function = withMaskAsSteps(masked);
    CurvePreset preset;
    preset.name = name;
    const std::vector<TransferPoint>& points = function.points;
    const double apart = leastApart(function);
    for (std::size_t point = 0; point < points.size(); ++point) {
        const bool endsBelow = point + 1 < points.size() && points[point + 1].value == points[point].value;
        const double value = points[point].value - (endsBelow ? apart : 0);
        const auto& colour = points[point].colour;
        preset.colours.nodes.push_back({value, {colour[0], colour[1], colour[2]}});
        preset.opacities.push_back({value, points[point].opacity});
        if (endsBelow || point + 1 == points.size())
            continue;
        const double to = points[point + 1].value;
        const auto opacity = [&](double share) {
            return share >= 1 ? points[point + 1].opacity
                              : lookOf(function, std::lerp(points[point].value, to, share)).opacity;
        };
        const auto matches = [&](double a, double b, double place) {
            const double line = std::lerp(opacity(a), opacity(b), (place - a) / (b - a));
            return std::abs(line - opacity(place)) <= tolerance;
        };
        for (const double share : adaptivePoints(matches))
            if (share > 0 && share < 1)
                preset.opacities.push_back({std::lerp(points[point].value, to, share), opacity(share)});
    }
    return preset;
}

namespace {

Error wrongCurve(const CurvePreset& preset, const Message& what)
{
    return {ErrorKind::BadInput, Message::say("The preset '%1' cannot be used: %2.", preset.name, what)};
}

bool isShare(double number)
{
    return number >= 0 && number <= 1;
}

template <class Node> Status checkValues(const CurvePreset& preset, std::span<const Node> nodes)
{
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (!std::isfinite(nodes[node].value))
            return wrongCurve(preset, Message::say("a value is not a finite number"));
        if (node > 0 && nodes[node].value < nodes[node - 1].value)
            return wrongCurve(preset,
                              Message::say("its values do not ascend: %1 comes after %2",
                                           formatNumber(nodes[node].value), formatNumber(nodes[node - 1].value)));
    }
    return {};
}

} // namespace

Status checkCurves(const CurvePreset& preset)
{
    if (Status ascending = checkValues(preset, std::span(preset.colours.nodes)); !ascending)
        return ascending;
    if (Status ascending = checkValues(preset, std::span(preset.opacities)); !ascending)
        return ascending;
    if (preset.colours.nodes.empty() && preset.opacities.empty())
        return wrongCurve(preset, Message::say("it has neither colours nor opacities"));
    if (preset.colours.logarithmic && !preset.colours.nodes.empty() && !(preset.colours.nodes.front().value > 0))
        return wrongCurve(preset, Message::say("its colours go by the logarithm, and its values are not all positive"));
    for (const ColourNode& node : preset.colours.nodes)
        if (!std::ranges::all_of(node.colour, isShare))
            return wrongCurve(preset, Message::say("a channel of a colour lies outside 0 to 1"));
    for (const OpacityNode& node : preset.opacities)
        if (!isShare(node.opacity) || !isShare(node.midpoint) || !isShare(node.sharpness))
            return wrongCurve(preset, Message::say("an opacity, a midpoint or a sharpness lies outside 0 to 1"));
    return {};
}

} // namespace tetra
