// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/axes.h"
#include "plugins/widgets/curves/joined_function.h"

#include <QPointF>
#include <QRectF>

#include <optional>

namespace tetra {

/// Where values and opacities lie in the editor's plot: values from left to right, opacities from the bottom to the
/// top. What lies outside of the seen part lies outside of the area.
struct TransferPlot {
    QRectF area;
    TransferLimits limits; ///< the values at the left and the right edge
    TransferLimits heights{};
    OpacityAxis axis = OpacityAxis::SquareRoot;
    ValueAxis valueAxis = ValueAxis::Linear;
    bool ofLogarithms = false; ///< the values are: EditorState::ofLogarithms()

    double x(double value) const;
    /// Of a place on the axis of values (placeOnAxis()).
    double xOfPlace(double place) const;
    double y(double opacity) const;
    double valueAt(double x) const;
    /// On the axis of values, of the seen part; in [0, 1] within the area.
    double shareAt(double x) const;
    /// The values at two such shares, which may lie outside of what is seen: what is seen after a zoom or a move.
    TransferLimits between(double from, double to) const;
    /// How far the axis of values goes from one edge to the other.
    double extent() const;
    /// On the axis of opacities, in [0, 1].
    double heightAt(double y) const;
    double opacityAt(double y) const;
    /// The two sides of a step lie beside each other, so that both can be grabbed.
    QPointF place(const JoinedFunction& function, std::size_t point) const;
    /// The point under the pointer; of several the nearest one.
    std::optional<std::size_t> pointAt(const JoinedFunction& function, QPointF place) const;
    /// Whether the pointer is on the curve.
    bool isOnCurve(const TransferFunction& function, QPointF place) const;
    /// The points in a rectangle of the plot.
    std::vector<std::size_t> pointsIn(const JoinedFunction& function, const QRectF& rectangle) const;
};

/// -1 for the lower side of a step, 1 for the upper one, 0 for a point.
int sideOf(const JoinedFunction& function, std::size_t point);

} // namespace tetra
