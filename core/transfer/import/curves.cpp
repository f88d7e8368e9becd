// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/import/curves.h"

#include "core/base/sort_unique.h"

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

ColourPoint pointOf(double value, const SrgbColour& colour)
{
    ColourPoint point{value};
    for (std::size_t channel = 0; channel < 3; ++channel)
        point.colour[channel] = static_cast<float>(std::clamp(colour[channel], 0.0, 1.0));
    return point;
}

OpacityPoint pointOf(double value, double opacity)
{
    return {value, static_cast<float>(std::clamp(opacity, 0.0, 1.0))};
}

/// What our curves are between two points: colours go straight, opacities as extinctions do.
SrgbColour lookBetween(const ColourPoint& from, const ColourPoint& to, double share)
{
    SrgbColour colour{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        colour[channel] = std::lerp(double{from.colour[channel]}, double{to.colour[channel]}, share);
    return colour;
}

double lookBetween(const OpacityPoint& from, const OpacityPoint& to, double share)
{
    return -std::expm1(-std::lerp(extinctionOf(from.opacity, 1), extinctionOf(to.opacity, 1), share));
}

bool near(double left, double right, double allowed)
{
    return std::abs(left - right) <= allowed;
}

bool near(const SrgbColour& left, const SrgbColour& right, double allowed)
{
    return std::ranges::equal(left, right, [&](double a, double b) { return near(a, b, allowed); });
}

/// Whether two points are one but for rounding: no step.
template <class Point> bool same(const Point& left, const Point& right)
{
    return left.value == right.value && near(lookBetween(left, left, 0), lookBetween(right, right, 0), 1e-6);
}

/// The nodes' values, each once.
template <class Node> std::vector<double> valuesOf(const std::vector<Node>& nodes)
{
    std::vector<double> values;
    for (const Node& node : nodes)
        values.push_back(node.value);
    values.erase(std::ranges::unique(values).begin(), values.end());
    return values;
}

/// How a stretch is halved: a logarithmic curve by factors, since over many powers of ten nearly all of it lies in a
/// part of the values that no halving of the values comes down to.
enum class Halving { ByDifference, ByFactor };

double valueAlong(double from, double to, double share, Halving halving)
{
    return halving == Halving::ByFactor ? from * std::pow(to / from, share) : std::lerp(from, to, share);
}

/// The points of a curve of ours that is near to `look` everywhere. That has its kinks and steps at `values` alone,
/// which ascend; those that are no farther apart than `narrow` are the sides of a step.
template <class Point, class Look>
std::vector<Point> sampled(const std::vector<double>& values, double narrow, Halving halving, const Look& look)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Point> points;
    const auto add = [&points](const Point& point) {
        if (points.empty() || !same(points.back(), point))
            points.push_back(point);
    };
    if (!values.empty())
        add(pointOf(values.front(), look(std::nextafter(values.front(), -infinity))));
    for (std::size_t stretch = 0; stretch + 1 < values.size(); ++stretch) {
        const double from = values[stretch], to = values[stretch + 1];
        // Just inside: at the ends themselves the curve may step.
        const double first = std::nextafter(from, to), last = std::nextafter(to, from);
        const auto pointAt = [&](double share) {
            const double value = share <= 0 ? from : share >= 1 ? to : valueAlong(from, to, share, halving);
            return pointOf(value, look(std::clamp(value, first, last)));
        };
        if (to - from <= narrow) {
            add(pointAt(0));
            // The upper side of a step stays where it is.
            if (points.size() > 1 && points[points.size() - 2].value == from)
                points.push_back(points.back());
            points.back().value = to;
            continue;
        }
        const auto matches = [&](double a, double b, double place) {
            const Point one = pointAt(a), other = pointAt(b);
            const double value = valueAlong(from, to, place, halving);
            return near(lookBetween(one, other, (value - one.value) / (other.value - one.value)),
                        look(std::clamp(value, first, last)), tolerance);
        };
        for (const double share : adaptivePoints(matches))
            add(pointAt(share));
    }
    if (!values.empty())
        add(pointOf(values.back(), look(std::nextafter(values.back(), infinity))));
    return points;
}

std::vector<ColourPoint> coloursOf(const ColourCurve& curve, double narrow)
{
    const Halving halving = curve.logarithmic ? Halving::ByFactor : Halving::ByDifference;
    return sampled<ColourPoint>(valuesOf(curve.nodes), narrow, halving,
                                [&curve](double value) { return curveColourAt(curve, value); });
}

std::vector<OpacityPoint> opacitiesOf(const std::vector<OpacityNode>& nodes, double narrow)
{
    std::vector<double> values = valuesOf(nodes);
    // A sharp opacity steps at its midpoint.
    for (std::size_t node = 0; node + 1 < nodes.size(); ++node)
        if (nodes[node].sharpness > 0.99)
            values.push_back(std::lerp(nodes[node].value, nodes[node + 1].value, nodes[node].midpoint));
    sortUnique(values);
    return sampled<OpacityPoint>(values, narrow, Halving::ByDifference,
                                 [&nodes](double value) { return opacityAt(nodes, value); });
}

/// The largest distance of two values that are the sides of a step, as ParaView has it.
template <class Node> double narrowOf(const std::vector<Node>& nodes)
{
    return nodes.empty() ? 0 : 2e-9 * (nodes.back().value - nodes.front().value);
}

} // namespace

TransferFunction transferFunctionOf(const CurvePreset& preset, const TransferFunction& present)
{
    TransferFunction function = present;
    const double narrow = std::max(narrowOf(preset.colours.nodes), narrowOf(preset.opacities));
    if (!preset.colours.nodes.empty())
        function.colours = coloursOf(preset.colours, narrow);
    if (!preset.opacities.empty()) {
        function.opacities = opacitiesOf(preset.opacities, narrow);
        function.mask.reset();
    }
    return function;
}

namespace {

/// The least distance of two values of the function that ParaView keeps in order: a billionth of the range.
double leastApart(const TransferFunction& function)
{
    const std::vector<TransferPoint> points = transferPoints(function);
    if (points.empty())
        return 0;
    const double first = points.front().value, last = points.back().value;
    return 1e-9 * (last > first ? last - first : std::max(1.0, std::abs(first)));
}

void addPointAt(const TransferFunction& function, double value, std::vector<OpacityPoint>& opacities)
{
    const auto after = std::ranges::upper_bound(opacities, value, {}, &OpacityPoint::value);
    if (after == opacities.begin() || after[-1].value != value)
        opacities.insert(
            after, pointOf(value, -std::expm1(-evaluateUnmasked(function, value).extinction * function.unitDistance)));
}

/// Opacities without a mask that look as those with it: what the mask hides has the opacity 0. The mask's largest value
/// is still seen, so the step there is `apart` above it.
std::vector<OpacityPoint> opacitiesWithMask(const TransferFunction& function, double apart)
{
    std::vector<OpacityPoint> points = function.opacities;
    if (!function.mask || points.empty())
        return points;
    const TransferMask mask = *function.mask;
    addPointAt(function, mask.least, points);
    addPointAt(function, mask.largest, points);

    const auto above = std::ranges::upper_bound(points, mask.largest, {}, &OpacityPoint::value);
    for (auto point = above; point != points.end(); ++point)
        point->opacity = 0;
    double hidden = mask.largest + apart;
    if (above != points.end())
        hidden = std::min(hidden, std::midpoint(mask.largest, above->value));
    points.insert(above, OpacityPoint{hidden});

    const auto first = std::ranges::lower_bound(points, mask.least, {}, &OpacityPoint::value);
    for (auto point = points.begin(); point != first; ++point)
        point->opacity = 0;
    if (std::ranges::count(points, mask.least, &OpacityPoint::value) > 1)
        first->opacity = 0;
    else
        points.insert(first, OpacityPoint{mask.least});
    return points;
}

/// Whether the point is the lower side of a step.
template <class Point> bool endsBelow(const std::vector<Point>& points, std::size_t point)
{
    return point + 1 < points.size() && points[point + 1].value == points[point].value;
}

} // namespace

CurvePreset curvesOf(const TransferFunction& function, const std::string& name)
{
    CurvePreset preset;
    preset.name = name;
    const double apart = leastApart(function);
    const auto& colours = function.colours;
    for (std::size_t point = 0; point < colours.size(); ++point) {
        const auto& [red, green, blue] = colours[point].colour;
        preset.colours.nodes.push_back(
            {colours[point].value - (endsBelow(colours, point) ? apart : 0), {red, green, blue}});
    }
    const std::vector<OpacityPoint> opacities = opacitiesWithMask(function, apart);
    for (std::size_t point = 0; point < opacities.size(); ++point) {
        const OpacityPoint& from = opacities[point];
        const bool isLower = endsBelow(opacities, point);
        preset.opacities.push_back({from.value - (isLower ? apart : 0), from.opacity});
        if (isLower || point + 1 == opacities.size())
            continue;
        const OpacityPoint& to = opacities[point + 1];
        const auto opacity = [&](double share) { return lookBetween(from, to, share); };
        const auto matches = [&](double a, double b, double place) {
            return near(std::lerp(opacity(a), opacity(b), (place - a) / (b - a)), opacity(place), tolerance);
        };
        for (const double share : adaptivePoints(matches))
            if (share > 0 && share < 1)
                preset.opacities.push_back({std::lerp(from.value, to.value, share), opacity(share)});
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
                              Message::say("its values are not in ascending order: %1 comes after %2",
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
        return wrongCurve(preset,
                          Message::say("its colours follow the logarithm, and its values are not all positive"));
    for (const ColourNode& node : preset.colours.nodes)
        if (!std::ranges::all_of(node.colour, isShare))
            return wrongCurve(preset, Message::say("a channel of a colour lies outside 0 to 1"));
    for (const OpacityNode& node : preset.opacities)
        if (!isShare(node.opacity) || !isShare(node.midpoint) || !isShare(node.sharpness))
            return wrongCurve(preset, Message::say("an opacity, a midpoint or a sharpness lies outside 0 to 1"));
    return {};
}

} // namespace tetra
