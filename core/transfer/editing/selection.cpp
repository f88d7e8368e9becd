// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/editing/selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

template <class Wanted> TransferSelection pointsThat(const TransferFunction& function, const Wanted& wanted)
{
    TransferSelection selection;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (wanted(function.points[i]))
            selection.push_back(i);
    return selection;
}

template <class Change>
EditedSelection changed(const TransferFunction& function, const TransferSelection& selection, const Change& change)
{
    EditedSelection edited{function, selection};
    for (const std::size_t i : selection)
        if (i < edited.function.points.size())
            change(edited.function.points[i]);
    return edited;
}

} // namespace

TransferSelection selectionOf(const TransferFunction& function, std::vector<std::size_t> points)
{
    std::erase_if(points, [&](std::size_t point) { return point >= function.points.size(); });
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
    return points;
}

TransferSelection allPoints(const TransferFunction& function)
{
    TransferSelection selection(function.points.size());
    std::iota(selection.begin(), selection.end(), std::size_t(0));
    return selection;
}

TransferSelection pointsWithin(const TransferFunction& function, const TransferLimits& values,
                               const TransferLimits& opacities)
{
    return pointsThat(function, [&](const TransferPoint& point) {
        return point.value >= values.least && point.value <= values.largest && point.opacity >= opacities.least &&
               point.opacity <= opacities.largest;
    });
}

TransferSelection pointsOfGroup(const TransferFunction& function, int group)
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

EditedSelection withoutSelected(const TransferFunction& function, const TransferSelection& selection)
{
    EditedSelection edited{function, {}};
    edited.function.points.clear();
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (!std::ranges::binary_search(selection, i))
            edited.function.points.push_back(function.points[i]);
    return edited;
}

EditedSelection withColour(const TransferFunction& function, const TransferSelection& selection,
                           const std::array<float, 3>& colour)
{
    if (!std::ranges::all_of(colour, [](float channel) { return channel >= 0 && channel <= 1; }))
        return {function, selection};
    return changed(function, selection, [&](TransferPoint& point) { point.colour = colour; });
}

EditedSelection withOpacity(const TransferFunction& function, const TransferSelection& selection, double opacity)
{
    if (!std::isfinite(opacity))
        return {function, selection};
    const auto cut = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
    return changed(function, selection, [&](TransferPoint& point) { point.opacity = cut; });
}

EditedSelection withGroup(const TransferFunction& function, const TransferSelection& selection,
                          std::optional<int> group)
{
    if (group && (*group < 0 || *group > largestTransferGroup))
        return {function, selection};
    return changed(function, selection, [&](TransferPoint& point) { point.group = group; });
}

} // namespace tetra
