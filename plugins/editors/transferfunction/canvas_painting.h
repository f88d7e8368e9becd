// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"
#include "plugins/editors/transferfunction/transfer_plot.h"

#include <QColor>
#include <QPalette>
#include <QRectF>
#include <QString>

#include <vector>

class QFontMetrics;
class QPainter;

namespace tetra {

/// What is painted of the editor's state, and where.
struct CanvasScene {
    const EditorState& state;
    TransferPlot plot;
    QPalette palette;
    bool isEnabled = true;
    bool hasFocus = false;
    bool showsIsovalues = true;   ///< what is drawn has their surfaces
    std::optional<QRectF> band{}; ///< the frame that is being drawn around points

    const JoinedFunction& function() const { return state.joinedFunction(); }
};

/// The plot's area in a canvas of this size: room for the handles above it, the opacities on its left, and below it
/// the colours and the values.
QRectF plotArea(const QRectF& canvas, const QFontMetrics& font);

void paintCanvas(QPainter& painter, const CanvasScene& scene, const QRectF& canvas);

/// The parts of it; canvas_axes.cpp has the first.
void paintAxes(QPainter& painter, const CanvasScene& scene);
/// Where something of the function or an isovalue lies outside of what is seen, and how many.
void paintWhatIsOutside(QPainter& painter, const CanvasScene& scene);
/// The isovalues and the ends of the mask, with handles.
void paintMarkers(QPainter& painter, const CanvasScene& scene);
/// The value that is picked in the picture: a line, and the value as text; at an edge if it lies outside of what is
/// seen.
void paintPicked(QPainter& painter, const CanvasScene& scene);

/// What stands below the plot: the values at its ends, and that in the middle where there is room for it. None touches
/// another; where not even the ends have room, the one on the right is left out.
struct AxisLabel {
    QString text;
    QRectF place;
};
std::vector<AxisLabel> valueLabels(const TransferPlot& plot, const QFontMetrics& font);

/// Where the group of a point is written: above it on the right, elsewhere where there is no room.
QRectF groupLabel(const TransferPlot& plot, const JoinedFunction& function, std::size_t point,
                  const QFontMetrics& font);

/// How often the values occur, in equal parts of the axis; its ends are places on it. None before the first mesh.
std::shared_ptr<const ValueHistogram> histogramOn(ValueAxis axis, const EditorHost& host);

/// How many points, isovalues and ends of the mask lie to the left and to the right of what is seen.
struct OutsideCounts {
    int left = 0;
    int right = 0;
};
OutsideCounts countOutside(const EditorState& state);

/// The height of the strip of colours below the plot.
inline constexpr double stripHeight = 10;
/// Of the handles above the plot.
inline constexpr double handleHeight = 9;

QColor faded(const QColor& colour, double opacity);
QColor colourAt(const TransferFunction& function, double value);

} // namespace tetra
