// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/chart.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr double textHeight = 20;
constexpr double legendWidth = 250;

/// A logarithmic axis from whole decade to whole decade.
class Axis {
public:
    void include(double value)
    {
        first_ = std::min(first_, std::floor(std::log10(value)));
        last_ = std::max(last_, std::ceil(std::log10(value)));
    }
    /// 0 at the axis's beginning, 1 at its end.
    double share(double value) const { return (std::log10(value) - first_) / std::max(last_ - first_, 1.0); }
    bool empty() const { return first_ > last_; }

    /// One to nine times each power of ten.
    std::vector<double> ticks() const
    {
        std::vector<double> values;
        for (double decade = first_; decade <= last_; ++decade)
            for (int digit = 1; digit <= (decade < last_ ? 9 : 1); ++digit)
                values.push_back(digit * std::pow(10, decade));
        return values;
    }

private:
    double first_ = std::numeric_limits<double>::infinity();
    double last_ = -std::numeric_limits<double>::infinity();
};

bool isPowerOfTen(double value)
{
    const double logarithm = std::log10(value);
    return std::abs(logarithm - std::round(logarithm)) < 1e-9;
}

/// The chart on its way to the paper.
class ChartDrawing {
public:
    ChartDrawing(QPainter& painter, const QRectF& frame, const Chart& chart)
        : painter_(painter), frame_(frame), plot_(frame.adjusted(90, 50, -legendWidth, -60)), chart_(chart)
    {
        for (const ChartSeries& series : chart.series)
            for (const QPointF& point : series.points) {
                horizontal_.include(point.x());
                vertical_.include(point.y());
            }
    }

    void draw()
    {
        drawTitles();
        if (horizontal_.empty())
            return;
        drawGrid();
        for (const ChartSeries& series : chart_.series)
            drawSeries(series);
        drawLegend();
    }

private:
    QPointF place(const QPointF& value) const
    {
        return {plot_.left() + horizontal_.share(value.x()) * plot_.width(),
                plot_.bottom() - vertical_.share(value.y()) * plot_.height()};
    }

    void drawTitles()
    {
        painter_.setPen(Qt::black);
        painter_.drawText(QRectF(frame_.left(), frame_.top() + 12, frame_.width(), textHeight), Qt::AlignHCenter,
                          chart_.title);
        painter_.drawText(QRectF(plot_.left(), plot_.bottom() + 32, plot_.width(), textHeight), Qt::AlignHCenter,
                          chart_.horizontal);
        painter_.save();
        painter_.translate(frame_.left() + 12, plot_.bottom());
        painter_.rotate(-90);
        painter_.drawText(QRectF(0, 0, plot_.height(), textHeight), Qt::AlignHCenter, chart_.vertical);
        painter_.restore();
    }

    void drawGrid()
    {
        const QPen fine(QColor(230, 230, 230), 1);
        const QPen coarse(QColor(170, 170, 170), 1);
        for (const double value : horizontal_.ticks()) {
            const double x = plot_.left() + horizontal_.share(value) * plot_.width();
            painter_.setPen(isPowerOfTen(value) ? coarse : fine);
            painter_.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
            if (isPowerOfTen(value))
                drawNumber(QRectF(x - 50, plot_.bottom() + 6, 100, textHeight), Qt::AlignHCenter, value);
        }
        for (const double value : vertical_.ticks()) {
            const double y = plot_.bottom() - vertical_.share(value) * plot_.height();
            painter_.setPen(isPowerOfTen(value) ? coarse : fine);
            painter_.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
            if (isPowerOfTen(value))
                drawNumber(QRectF(plot_.left() - 80, y - textHeight / 2, 74, textHeight),
                           Qt::AlignRight | Qt::AlignVCenter, value);
        }
    }

    void drawNumber(const QRectF& where, int alignment, double value)
    {
        painter_.setPen(Qt::black);
        painter_.drawText(where, alignment,
                          value < 1 ? QLocale::c().toString(value, 'g', 6)
                                    : QLocale(QLocale::English).toString(value, 'f', 0));
    }

    void drawSeries(const ChartSeries& series)
    {
        painter_.setPen(QPen(series.colour, 2));
        painter_.setBrush(Qt::NoBrush);
        QPolygonF line;
        for (const QPointF& point : series.points)
            line << place(point);
        if (series.joined)
            painter_.drawPolyline(line);
        else
            for (const QPointF& point : line)
                painter_.drawEllipse(point, 4, 4);
    }

    void drawLegend()
    {
        double y = plot_.top();
        for (const ChartSeries& series : chart_.series) {
            if (series.name.isEmpty())
                continue;
            const double left = plot_.right() + 16;
            const double middle = y + textHeight / 2;
            painter_.setPen(QPen(series.colour, 2));
            if (series.joined)
                painter_.drawLine(QPointF(left, middle), QPointF(left + 24, middle));
            else
                painter_.drawEllipse(QPointF(left + 12, middle), 4, 4);
            painter_.setPen(Qt::black);
            painter_.drawText(QRectF(left + 32, y, legendWidth - 48, textHeight), Qt::AlignVCenter, series.name);
            y += textHeight + 4;
        }
    }

    QPainter& painter_;
    QRectF frame_;
    QRectF plot_;
    const Chart& chart_;
    Axis horizontal_;
    Axis vertical_;
};

} // namespace

QColor chartColour(std::size_t number)
{
    static constexpr std::array<QRgb, 8> colours = {0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7,
                                                    0xffe69f00, 0xff56b4e9, 0xff000000, 0xff999933};
    return QColor::fromRgb(colours[number % colours.size()]);
}

void drawChart(QPainter& painter, const QRectF& frame, const Chart& chart)
{
    painter.fillRect(frame, Qt::white);
    ChartDrawing(painter, frame, chart).draw();
}

} // namespace tetra
