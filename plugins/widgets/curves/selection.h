// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/joined_function.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// What an editor does with several points of a transfer function at once (R18), as values; see joined_function.h.
/// Points that do not exist are passed over.

/// Points of a function by their indices: ascending, each once.
using TransferSelection = std::vector<std::size_t>;

/// A function after an edit, and where its selected points are in it.
struct EditedSelection {
    JoinedFunction function;
    TransferSelection selection;
    bool operator==(const EditedSelection&) const = default;
};

/// Indices in any order, some twice or of no point, as a selection.
TransferSelection selectionOf(const JoinedFunction& function, std::vector<std::size_t> points);
TransferSelection allPoints(const JoinedFunction& function);
/// The points in a rectangle, its edges included: values and opacities.
TransferSelection pointsWithin(const JoinedFunction& function, const TransferLimits& values,
                               const TransferLimits& opacities);
TransferSelection pointsOfGroup(const JoinedFunction& function, int group);

/// The selection with the point if it was without, and without it if it was with it.
TransferSelection toggled(const TransferSelection& selection, std::size_t point);

/// What follows is O(points) each. The selection stays as it is but for deleting, which leaves none.

EditedSelection withoutSelected(const JoinedFunction& function, const TransferSelection& selection);
/// A colour with a channel outside [0, 1] changes nothing.
EditedSelection withColour(const JoinedFunction& function, const TransferSelection& selection,
                           const std::array<float, 3>& colour);
/// Opacities are cut to [0, 1]; one that is not finite changes nothing.
EditedSelection withOpacity(const JoinedFunction& function, const TransferSelection& selection, double opacity);
/// A group of 0 to 9, or none; another one changes nothing.
EditedSelection withGroup(const JoinedFunction& function, const TransferSelection& selection, std::optional<int> group);

/// Points on their way to other values, for the edits in this folder.

/// The points of one value: one, or both sides of a step.
struct PointColumn {
    std::size_t first = 0;
    std::size_t last = 0;
    double value = 0;
    bool selected = false; ///< one of the points is
};

/// In ascending order. O(points).
std::vector<PointColumn> columnsOf(const JoinedFunction& function, const TransferSelection& selection);

/// The least distance that points keep from each other within limits: far above rounding, far below what can be seen.
double leastDistanceIn(const TransferLimits& limits) noexcept;

/// The function with its columns at other values, one for each, and with the selection where its points are then.
/// Columns that are selected keep off the values of the others. O(points log points).
EditedSelection withColumnsAt(const JoinedFunction& function, const TransferSelection& selection,
                              std::span<const PointColumn> columns, std::vector<double> values,
                              const TransferLimits& limits);

/// The function with more points, which alone are selected; they are in ascending order and keep off the values of
/// those that are there.
EditedSelection withMorePoints(const JoinedFunction& function, std::vector<TransferPoint> points,
                               const TransferLimits& limits);

} // namespace tetra
