// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_editing.h"

#include <QPointF>
#include <QRectF>

#include <optional>

namespace tetra {

/// Where values and opacities lie in the editor's plot: values from left to right, opacities from the bottom to the top
/// by their square root, because clouds are seen through: most opacities are small.
struct TransferPlot {
    QRectF area;
    TransferLimits limits; ///< the values at the left and the right edge

    double x(double value) const;
    double y(double opacity) const;
    double valueAt(double x) const;
    double opacityAt(double y) const;
    QPointF place(const TransferPoint& point) const;
    /// The point under the pointer; of a step's two sides the nearer one.
    std::optional<std::size_t> pointAt(const TransferFunction& function, QPointF place) const;
};

/// Opacity of the unit distance, in [0, 1], where a function has this value.
double opacityOf(const TransferFunction& function, double value);

} // namespace tetra
