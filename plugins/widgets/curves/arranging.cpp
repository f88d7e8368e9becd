// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/arranging.h"

#include "plugins/widgets/curves/selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>

namespace tetra {
namespace {

double alignedTo(const std::vector<double>& numbers, Alignment alignment)
{
    switch (alignment) {
    case Alignment::First: return numbers.front();
    case Alignment::Least: return std::ranges::min(numbers);
    case Alignment::Largest: return std::ranges::max(numbers);
    case Alignment::Mean: break;
    }
    const double mean = std::reduce(numbers.begin(), numbers.end()) / static_cast<double>(numbers.size());
    return std::clamp(mean, std::ranges::min(numbers), std::ranges::max(numbers));
}

/// Those that exist.
TransferSelection existing(const JoinedFunction& function, const TransferSelection& selection)
{
    return selectionOf(function, selection);
}

/// The values of all columns, and which columns are selected.
struct Columns {
    std::vector<PointColumn> all;
    std::vector<double> values;
    std::vector<std::size_t> selected;
};

Columns columnsFor(const JoinedFunction& function, const TransferSelection& selection)
{
    Columns columns{columnsOf(function, selection), {}, {}};
    for (std::size_t i = 0; i < columns.all.size(); ++i) {
        columns.values.push_back(columns.all[i].value);
        if (columns.all[i].selected)
            columns.selected.push_back(i);
    }
    return columns;
}

/// The sides of steps that are selected change places.
EditedSelection withSidesChanged(const JoinedFunction& function, const TransferSelection& selection,
                                 std::span<const PointColumn> columns)
{
    EditedSelection edited{function, selection};
    for (const PointColumn& column : columns) {
        if (!column.selected || column.first == column.last)
            continue;
        std::swap(edited.function.points[column.first], edited.function.points[column.last]);
        const bool first = std::ranges::binary_search(selection, column.first);
        if (first != std::ranges::binary_search(selection, column.last)) {
            edited.selection = toggled(edited.selection, column.first);
            edited.selection = toggled(edited.selection, column.last);
        }
    }
    return edited;
}

} // namespace

EditedSelection alignOpacities(const JoinedFunction& function, const TransferSelection& selection, Alignment alignment)
{
    std::vector<double> opacities;
    for (const std::size_t i : existing(function, selection))
        opacities.push_back(function.points[i].opacity);
    if (opacities.empty())
        return {function, selection};
    return withOpacity(function, selection, alignedTo(opacities, alignment));
}

EditedSelection alignValues(const JoinedFunction& function, const TransferSelection& selection, Alignment alignment)
{
    const bool neighbours = selection.size() == 2 && selection[1] == selection[0] + 1 &&
                            selection[1] < function.points.size() && !isOnStep(function, selection[0]) &&
                            !isOnStep(function, selection[1]);
    EditedSelection edited{function, selection};
    if (!neighbours)
        return edited;
    TransferPoint &lower = edited.function.points[selection[0]], &upper = edited.function.points[selection[1]];
    const double value = alignment == Alignment::Mean ? std::midpoint(lower.value, upper.value)
                                                      : alignedTo({lower.value, upper.value}, alignment);
    lower.value = upper.value = value;
    return edited;
}

EditedSelection distributeValues(const JoinedFunction& function, const TransferSelection& selection,
                                 const TransferLimits& limits)
{
    Columns columns = columnsFor(function, selection);
    if (columns.selected.size() < 3)
        return {function, selection};
    const double first = columns.values[columns.selected.front()], last = columns.values[columns.selected.back()];
    const auto intervals = static_cast<double>(columns.selected.size() - 1);
    for (std::size_t i = 0; i < columns.selected.size(); ++i)
        columns.values[columns.selected[i]] = std::lerp(first, last, static_cast<double>(i) / intervals);
    return withColumnsAt(function, selection, columns.all, std::move(columns.values), limits);
}

EditedSelection flipValues(const JoinedFunction& function, const TransferSelection& selection,
                           const TransferLimits& limits)
{
    Columns columns = columnsFor(function, selection);
    if (columns.selected.empty())
        return {function, selection};
    const double sum = columns.values[columns.selected.front()] + columns.values[columns.selected.back()];
    for (const std::size_t column : columns.selected)
        columns.values[column] = sum - columns.values[column];
    const EditedSelection turned = withSidesChanged(function, selection, columns.all);
    const EditedSelection flipped =
        withColumnsAt(turned.function, turned.selection, columns.all, std::move(columns.values), limits);
    return std::isfinite(sum) ? flipped : EditedSelection{function, selection};
}

EditedSelection invertOpacities(const JoinedFunction& function, const TransferSelection& selection)
{
    EditedSelection edited{function, selection};
    for (const std::size_t i : existing(function, selection))
        edited.function.points[i].opacity = 1 - edited.function.points[i].opacity;
    return edited;
}

EditedSelection rampOpacities(const JoinedFunction& function, const TransferSelection& selection)
{
    EditedSelection edited{function, selection};
    const TransferSelection points = existing(function, selection);
    if (points.size() < 3)
        return edited;
    const TransferPoint first = function.points[points.front()], last = function.points[points.back()];
    const double extent = last.value - first.value;
    if (!(extent > 0) || !std::isfinite(extent))
        return edited;
    for (const std::size_t i : points | std::views::drop(1) | std::views::take(points.size() - 2)) {
        const double share = (function.points[i].value - first.value) / extent;
        edited.function.points[i].opacity =
            static_cast<float>(std::lerp(static_cast<double>(first.opacity), static_cast<double>(last.opacity), share));
    }
    return edited;
}

} // namespace tetra
