// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

#include <vector>

class QPainter;
class QRectF;

namespace tetra {

/// Points in a chart: joined by a line, or each marked with a ring.
struct ChartSeries {
    QString name; ///< in the legend; empty for none
    QColor colour;
    std::vector<QPointF> points; ///< in the units of the axes, both positive
    bool joined = true;
};

/// A chart with two logarithmic axes.
struct Chart {
    QString title;
    QString horizontal; ///< what the axis shows, with its unit
    QString vertical;
    std::vector<ChartSeries> series;
};

/// Eight colours that people of any colour vision can tell apart (Okabe and Ito), over and over.
QColor chartColour(std::size_t number);

/// Draws the chart into `frame`, dark on a white ground.
void drawChart(QPainter& painter, const QRectF& frame, const Chart& chart);

} // namespace tetra
