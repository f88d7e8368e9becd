// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/editing/selection.h"

#include <span>
#include <vector>

namespace tetra {

/// Points on their way to other values, for the edits in this folder.

/// The points of one value: one, or both sides of a step.
struct PointColumn {
    std::size_t first = 0;
    std::size_t last = 0;
    double value = 0;
    bool selected = false; ///< one of the points is
};

/// In ascending order. O(points).
std::vector<PointColumn> columnsOf(const TransferFunction& function, const TransferSelection& selection);

/// The least distance that points keep from each other within limits: far above rounding, far below what can be seen.
double leastDistanceIn(const TransferLimits& limits) noexcept;

/// The function with its columns at other values, one for each, and with the selection where its points are then.
/// Columns that are selected keep off the values of the others. O(points log points).
EditedSelection withColumnsAt(const TransferFunction& function, const TransferSelection& selection,
                              std::span<const PointColumn> columns, std::vector<double> values,
                              const TransferLimits& limits);

/// The function with more points, which alone are selected; they are in ascending order and keep off the values of
/// those that are there.
EditedSelection withMorePoints(const TransferFunction& function, std::vector<TransferPoint> points,
                               const TransferLimits& limits);

} // namespace tetra
