// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/drawing.h"

#include <optional>

namespace tetra {

/// What stands over and beside every chart.
struct ChartTexts {
    std::string title;
    std::string note;        ///< below the title
    std::string unit;        ///< of the values
    std::string description; ///< in words, for those who cannot see it
};

/// A number that was asked for, as a line across the bars of a row and as text beside them.
struct BarLimit {
    double value = 0;
    std::string text;
    bool isMissed = false;
};

struct Bar {
    double value = 0;
    std::string text;
    ChartInk ink = ChartInk::Series;
};

/// What has a label at the left: bars below each other; none where nothing is known.
struct BarRow {
    std::string label;
    std::vector<std::optional<Bar>> bars;
    std::optional<BarLimit> limit;
};

/// Horizontal bars. The axis is linear from 0 on, or logarithmic, of positive values then.
struct BarChart {
    ChartTexts texts;
    std::vector<std::pair<std::string, ChartInk>> legend; ///< of the bars of each row; may be empty
    std::vector<BarRow> rows;
    bool isLogarithmic = false;
};

/// A name, beside the end of the line, and points in the units of the axes. Without a name it is not in the legend.
struct LineSeries {
    enum class Style { Line, Rings, MarkedLine };
    std::string name;
    ChartInk ink = ChartInk::Series;
    Points points;
    Style style = Style::Line;
};

/// Lines over two logarithmic axes; all coordinates are positive.
struct LineChart {
    ChartTexts texts;
    std::string across; ///< the unit of the horizontal axis
    std::vector<LineSeries> series;
    Eigen::Vector2d size = {780, 420};
};

/// There is at least one bar, one point.
Drawing drawChart(const BarChart& chart);
Drawing drawChart(const LineChart& chart);

} // namespace tetra
