// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/moving.h"

#include "plugins/widgets/curves/selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ranges>

namespace tetra {
namespace {

constexpr double noLimit = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12; ///< of a number from its logarithm and back

/// The columns seen in the direction of a move: `sign` is -1 for one downward, where all is mirrored, and 1 otherwise.
struct Way {
    std::vector<PointColumn> columns;
    double largest = 0; ///< where the limits end, mirrored too
    double sign = 1;
    double distance = 0; ///< that points keep

    double value(std::size_t column) const { return columns[column].value; }
    /// How far apart a column and the one after it stay: not farther than they are.
    double gap(std::size_t column) const { return std::min(distance, value(column + 1) - value(column)); }
};

Way wayOf(const JoinedFunction& function, const TransferSelection& selection, double by, const TransferLimits& limits)
{
    Way way{columnsOf(function, selection), by < 0 ? -limits.least : limits.largest, by < 0 ? -1.0 : 1.0,
            leastDistanceIn(limits)};
    if (way.sign < 0) {
        std::ranges::reverse(way.columns);
        for (PointColumn& column : way.columns)
            column.value = -column.value;
    }
    return way;
}

/// How far the selection can go, up to `wanted`, both not negative.
double allowed(const Way& way, double wanted, NeighbourRule rule)
{
    double room = noLimit, pushed = 0;
    for (std::size_t i = way.columns.size(); i-- > 0;) {
        const bool last = i + 1 == way.columns.size();
        if (rule == NeighbourRule::Push && !last && way.value(i + 1) <= way.largest)
            pushed += way.gap(i);
        if (!way.columns[i].selected)
            continue;
        room = std::min(room, way.largest - pushed - way.value(i));
        if (rule == NeighbourRule::Stop && !last && !way.columns[i + 1].selected)
            room = std::min(room, way.value(i + 1) - way.distance - way.value(i));
    }
    return std::clamp(wanted, 0.0, std::max(room, 0.0));
}

/// Where the columns come to lie, in the way's order and sign.
std::vector<double> valuesAfter(const Way& way, double by, NeighbourRule rule)
{
    std::vector<double> values;
    bool pushing = false;
    for (std::size_t i = 0; i < way.columns.size(); ++i) {
        double value = way.value(i);
        if (way.columns[i].selected)
            value = std::min(value + by, std::max(value, way.largest));
        else if (rule == NeighbourRule::Push && pushing)
            value = std::max(value, values.back() + way.gap(i - 1));
        pushing |= way.columns[i].selected;
        values.push_back(value);
    }
    return values;
}

JoinedFunction withHeights(JoinedFunction function, const TransferSelection& selection, const SelectionMove& move)
{
    if (move.height == 0 || !std::isfinite(move.height))
        return function;
    for (const std::size_t i : selection) {
        if (i >= function.points.size())
            continue;
        float& opacity = function.points[i].opacity;
        opacity = static_cast<float>(opacityAtHeight(heightOf(opacity, move.axis) + move.height, move.axis));
    }
    return function;
}

/// The function with its values' logarithms moved instead. What has not moved keeps its value to the last bit.
EditedSelection movedByFactor(const JoinedFunction& function, const TransferSelection& selection,
                              const SelectionMove& move, NeighbourRule rule, const TransferLimits& limits)
{
    if (!(limits.least > 0) || (!function.points.empty() && !(function.points.front().value > 0)))
        return {function, selection};
    JoinedFunction logarithms = function;
    std::map<double, double> values; // by their logarithms
    for (TransferPoint& point : logarithms.points) {
        const double value = point.value;
        point.value = std::log(value);
        values.emplace(point.value, value);
    }
    EditedSelection edited =
        moveSelected(logarithms, selection, {.value = move.value}, rule, placesOnAxis(limits, ValueAxis::Logarithmic));
    for (TransferPoint& point : edited.function.points) {
        const auto unmoved = values.find(point.value);
        point.value = unmoved != values.end() ? unmoved->second : std::exp(point.value);
        for (const double limit : {limits.least, limits.largest})
            if (std::abs(point.value - limit) <= rounding * limit)
                point.value = limit;
    }
    return checkTransferFunction(separated(edited.function)) ? edited : EditedSelection{function, selection};
}

} // namespace

EditedSelection moveSelected(const JoinedFunction& function, const TransferSelection& selection,
                             const SelectionMove& move, NeighbourRule rule, const TransferLimits& limits)
{
    const JoinedFunction higher = withHeights(function, selection, move);
    if (move.value == 0 || !std::isfinite(move.value) || selection.empty())
        return {higher, selection};
    if (move.valueAxis == ValueAxis::Logarithmic)
        return movedByFactor(higher, selection, move, rule, limits);
    Way way = wayOf(higher, selection, move.value, limits);
    const double by = allowed(way, std::abs(move.value), rule);
    if (by == 0)
        return {higher, selection};
    std::vector<double> values = valuesAfter(way, by, rule);
    if (way.sign < 0) {
        std::ranges::reverse(way.columns);
        std::ranges::reverse(values);
        for (double& value : values)
            value = -value;
    }
    return withColumnsAt(higher, selection, way.columns, std::move(values), limits);
}

EditedSelection withValue(const JoinedFunction& function, const TransferSelection& selection, double value,
                          NeighbourRule rule, const TransferLimits& limits)
{
    if (selection.empty() || selection.front() >= function.points.size())
        return {function, selection};
    const double by = value - function.points[selection.front()].value;
    return moveSelected(function, selection, {by, 0, OpacityAxis::Linear}, rule, limits);
}

} // namespace tetra
