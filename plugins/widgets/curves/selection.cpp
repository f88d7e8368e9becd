// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace tetra {

namespace {

template <class Wanted> TransferSelection pointsThat(const JoinedFunction& function, const Wanted& wanted)
{
    TransferSelection selection;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (wanted(function.points[i]))
            selection.push_back(i);
    return selection;
}

template <class Change>
EditedSelection changed(const JoinedFunction& function, const TransferSelection& selection, const Change& change)
{
    EditedSelection edited{function, selection};
    for (const std::size_t i : selection)
        if (i < edited.function.points.size())
            change(edited.function.points[i]);
    return edited;
}

} // namespace

TransferSelection selectionOf(const JoinedFunction& function, std::vector<std::size_t> points)
{
    std::erase_if(points, [&](std::size_t point) { return point >= function.points.size(); });
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
    return points;
}

TransferSelection allPoints(const JoinedFunction& function)
{
    TransferSelection selection(function.points.size());
    std::iota(selection.begin(), selection.end(), std::size_t(0));
    return selection;
}

TransferSelection pointsWithin(const JoinedFunction& function, const TransferLimits& values,
                               const TransferLimits& opacities)
{
    return pointsThat(function, [&](const TransferPoint& point) {
        return point.value >= values.least && point.value <= values.largest && point.opacity >= opacities.least &&
               point.opacity <= opacities.largest;
    });
}

TransferSelection pointsOfGroup(const JoinedFunction& function, int group)
{
    return pointsThat(function, [group](const TransferPoint& point) { return point.group == group; });
}

TransferSelection toggled(const TransferSelection& selection, std::size_t point)
{
    TransferSelection result = selection;
    const auto at = std::ranges::lower_bound(result, point);
    if (at != result.end() && *at == point)
        result.erase(at);
    else
        result.insert(at, point);
    return result;
}

EditedSelection withoutSelected(const JoinedFunction& function, const TransferSelection& selection)
{
    EditedSelection edited{function, {}};
    edited.function.points.clear();
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (!std::ranges::binary_search(selection, i))
            edited.function.points.push_back(function.points[i]);
    return edited;
}

EditedSelection withColour(const JoinedFunction& function, const TransferSelection& selection,
                           const std::array<float, 3>& colour)
{
    if (!std::ranges::all_of(colour, [](float channel) { return channel >= 0 && channel <= 1; }))
        return {function, selection};
    return changed(function, selection, [&](TransferPoint& point) { point.colour = colour; });
}

EditedSelection withOpacity(const JoinedFunction& function, const TransferSelection& selection, double opacity)
{
    if (!std::isfinite(opacity))
        return {function, selection};
    const auto cut = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
    return changed(function, selection, [&](TransferPoint& point) { point.opacity = cut; });
}

EditedSelection withGroup(const JoinedFunction& function, const TransferSelection& selection, std::optional<int> group)
{
    if (group && (*group < 0 || *group > largestTransferGroup))
        return {function, selection};
    return changed(function, selection, [&](TransferPoint& point) { point.group = group; });
}

namespace {

struct MarkedPoint {
    TransferPoint point;
    bool selected = false;
};

/// In order, and of points of one value the first and the last. What the function was before if that is no function.
EditedSelection settled(const JoinedFunction& before, const TransferSelection& selectionBefore,
                        std::vector<MarkedPoint> marked)
{
    const auto valueOf = [](const MarkedPoint& one) { return one.point.value; };
    std::ranges::stable_sort(marked, {}, valueOf);
    EditedSelection edited{before, {}};
    auto& points = edited.function.points;
    points.clear();
    for (std::size_t i = 0; i < marked.size(); ++i) {
        const bool between = i > 0 && i + 1 < marked.size() && valueOf(marked[i - 1]) == valueOf(marked[i]) &&
                             valueOf(marked[i]) == valueOf(marked[i + 1]);
        if (between)
            continue;
        if (marked[i].selected)
            edited.selection.push_back(points.size());
        points.push_back(marked[i].point);
    }
    return checkTransferFunction(separated(edited.function)) ? edited : EditedSelection{before, selectionBefore};
}

/// The nearest to `value` that is not taken, going away from the limits' ends.
double freeValue(const std::set<double>& taken, double value, const TransferLimits& limits)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double distance = leastDistanceIn(limits);
    const bool down = value + distance > limits.largest;
    while (taken.contains(value))
        value = down ? std::min(value - distance, std::nextafter(value, -infinity))
                     : std::max(value + distance, std::nextafter(value, infinity));
    return value;
}

} // namespace

std::vector<PointColumn> columnsOf(const JoinedFunction& function, const TransferSelection& selection)
{
    std::vector<PointColumn> columns;
    for (std::size_t i = 0; i < function.points.size(); ++i) {
        const double value = function.points[i].value;
        const bool selected = std::ranges::binary_search(selection, i);
        if (columns.empty() || columns.back().value != value)
            columns.push_back({i, i, value, false});
        columns.back().last = i;
        columns.back().selected |= selected;
    }
    return columns;
}

double leastDistanceIn(const TransferLimits& limits) noexcept
{
    constexpr double share = 1e-5;
    const double distance = share * (limits.largest - limits.least);
    return std::isfinite(distance) ? std::max(distance, 0.0) : 0;
}

EditedSelection withColumnsAt(const JoinedFunction& function, const TransferSelection& selection,
                              std::span<const PointColumn> columns, std::vector<double> values,
                              const TransferLimits& limits)
{
    std::set<double> taken;
    for (std::size_t column = 0; column < columns.size(); ++column)
        if (!columns[column].selected)
            taken.insert(values[column]);
    std::vector<MarkedPoint> marked;
    for (std::size_t column = 0; column < columns.size(); ++column) {
        if (columns[column].selected)
            values[column] = freeValue(taken, values[column], limits);
        taken.insert(values[column]);
        for (std::size_t i = columns[column].first; i <= columns[column].last; ++i) {
            marked.push_back({function.points[i], std::ranges::binary_search(selection, i)});
            marked.back().point.value = values[column];
        }
    }
    return settled(function, selection, std::move(marked));
}

EditedSelection withMorePoints(const JoinedFunction& function, std::vector<TransferPoint> points,
                               const TransferLimits& limits)
{
    std::set<double> taken;
    std::vector<MarkedPoint> marked;
    for (const TransferPoint& point : function.points) {
        taken.insert(point.value);
        marked.push_back({point, false});
    }
    double before = std::numeric_limits<double>::quiet_NaN(), place = 0;
    for (TransferPoint& point : points) {
        if (point.value != before)
            place = freeValue(taken, point.value, limits);
        before = point.value;
        taken.insert(place);
        point.value = place;
        marked.push_back({point, true});
    }
    return settled(function, {}, std::move(marked));
}

} // namespace tetra
