// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/chart.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace tetra {
namespace {

constexpr double side = 16;       // of the drawing, left free
constexpr double lineHeight = 17; // of text
constexpr double top = 66;        // below title and note
constexpr double letterWidth = 6.7;
constexpr double barChartWidth = 780;
constexpr double labelWidth = 282;
constexpr double limitWidth = 126; // for what was asked for, in words
constexpr double barHeight = 15;

/// Thousands with commas; small numbers with as many digits as count.
std::string tickText(double value)
{
    constexpr int fewDigits = 6;
    const bool isWhole = value >= 1 && value == std::floor(value);
    std::array<char, 400> digits{}; // of the largest number there is, 309
    const auto [end, error] =
        isWhole
            ? std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, 0)
            : std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, fewDigits);
    std::string text(digits.data(), end);
    if (isWhole)
        for (std::size_t place = text.size(); place > 3; place -= 3)
            text.insert(place - 3, ",");
    return text;
}

/// Of a text in UTF-8.
std::size_t charactersOf(const std::string& text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

/// From values to places along an axis.
class Scale {
public:
    Scale(const std::vector<double>& values, double start, double end, bool isLogarithmic)
        : start_(start), end_(end), isLogarithmic_(isLogarithmic)
    {
        const auto [least, largest] = std::ranges::minmax_element(values);
        low_ = isLogarithmic ? 0.8 * *least : 0;
        high_ = (isLogarithmic ? 1.15 : 1.04) * *largest;
    }
    double place(double value) const
    {
        const double share =
            isLogarithmic_ ? std::log(std::max(value, low_) / low_) / std::log(high_ / low_) : value / high_;
        return start_ + share * (end_ - start_);
    }
    double middle() const { return (start_ + end_) / 2; }
    /// Round numbers, about seven.
    std::vector<double> ticks() const { return isLogarithmic_ ? logarithmicTicks() : linearTicks(); }

private:
    std::vector<double> linearTicks() const
    {
        double step = std::pow(10, std::floor(std::log10(high_ / 2)));
        for (const double factor : {1.0, 2.0, 5.0, 10.0})
            if (high_ / (factor * step) <= 6) {
                step *= factor;
                break;
            }
        std::vector<double> ticks;
        for (int i = 0; i * step <= high_; ++i)
            ticks.push_back(i * step);
        return ticks;
    }
    std::vector<double> logarithmicTicks() const
    {
        std::vector<double> ticks;
        for (const auto& factors : std::initializer_list<std::vector<double>>{{1, 2, 5}, {1, 3}, {1}}) {
            ticks.clear();
            for (double power = std::floor(std::log10(low_)); power <= std::ceil(std::log10(high_)); ++power)
                for (const double factor : factors)
                    if (const double tick = factor * std::pow(10, power); tick >= low_ && tick <= high_)
                        ticks.push_back(tick);
            if (ticks.size() <= 7)
                break;
        }
        return ticks;
    }

    double start_;
    double end_;
    bool isLogarithmic_;
    double low_;
    double high_;
};

void writeHeader(Drawing& drawing, const ChartTexts& texts)
{
    drawing.text({side, 26}, texts.title, Letters::Title);
    drawing.text({side, 26 + lineHeight}, texts.note, Letters::Soft);
}

void drawTick(Drawing& drawing, double x, double from, double to, double value)
{
    drawing.line({{x, from}, {x, to}}, ChartInk::Grid);
    drawing.text({x, to + lineHeight}, tickText(value), Letters::Soft, Anchor::Middle);
}

// Bars.

std::vector<double> valuesOf(const BarChart& chart)
{
    std::vector<double> values;
    for (const BarRow& row : chart.rows) {
        for (const auto& bar : row.bars)
            if (bar && (bar->value > 0 || !chart.isLogarithmic))
                values.push_back(bar->value);
        if (row.limit)
            values.push_back(row.limit->value);
    }
    return values;
}

double heightOf(const BarRow& row)
{
    return barHeight * static_cast<double>(row.bars.size()) + 12;
}

void drawLegend(Drawing& drawing, const BarChart& chart, bool hasLimits)
{
    double x = labelWidth;
    for (const auto& [name, ink] : chart.legend) {
        drawing.area(rectangle(x, top - 9, 11, 11), ink);
        drawing.text({x + 16, top + 1}, name, Letters::Soft);
        x += 26 + letterWidth * static_cast<double>(charactersOf(name));
    }
    if (!hasLimits)
        return;
    x = barChartWidth - limitWidth;
    drawing.text({x, top + 1}, "asked for", Letters::Soft);
    drawing.line({{x + 68, top - 10}, {x + 68, top + 4}}, ChartInk::Text, 2.5);
}

void drawRow(Drawing& drawing, const BarRow& row, const Scale& scale, double y)
{
    const double height = heightOf(row);
    const double middle = y + height / 2 + 5;
    drawing.text({side, middle}, row.label);
    double barTop = y + 6;
    for (const auto& bar : row.bars) {
        if (bar) {
            const double end = scale.place(bar->value);
            drawing.area(rectangle(labelWidth, barTop + 1, std::max(end - labelWidth, 1.0), barHeight - 3), bar->ink);
            drawing.text({end + 5, barTop + 12}, bar->text, row.limit ? Letters::Strong : Letters::Soft);
        }
        barTop += barHeight;
    }
    if (!row.limit)
        return;
    const double place = scale.place(row.limit->value);
    drawing.line({{place, y + 2}, {place, y + height - 2}}, ChartInk::Text, 2.5);
    drawing.text({barChartWidth - limitWidth, middle}, row.limit->text,
                 row.limit->isMissed ? Letters::Strong : Letters::Plain);
}

// Lines.

/// The ends of lines, as their names beside them need room: moved apart, and back into the chart.
std::vector<double> spread(std::vector<double> ends, double bottom)
{
    std::vector<std::size_t> order(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return ends[i]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        ends[order[i]] = std::max(ends[order[i]], ends[order[i - 1]] + lineHeight);
    double limit = bottom;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        ends[*i] = std::min(ends[*i], limit);
        limit = ends[*i] - lineHeight;
    }
    return ends;
}

/// What the horizontal axis has numbers for: the values themselves where they are few.
std::vector<double> placesAcross(const LineChart& chart, const Scale& scale)
{
    std::set<double> values;
    for (const LineSeries& series : chart.series)
        for (const Eigen::Vector2d& point : series.points)
            values.insert(point.x());
    return values.size() <= 8 ? std::vector(values.begin(), values.end()) : scale.ticks();
}

void drawRing(Drawing& drawing, const Eigen::Vector2d& place, ChartInk ink)
{
    drawing.dots({place}, ink, 9);
    drawing.dots({place}, ChartInk::Ground, 5);
}

/// A disc, a square or a triangle: lines differ without colours, too.
void drawMark(Drawing& drawing, const Eigen::Vector2d& place, std::size_t number, ChartInk ink)
{
    if (number % 3 == 0)
        drawing.dots({place}, ink, 8);
    else if (number % 3 == 1)
        drawing.area(rectangle(place.x() - 4, place.y() - 4, 8, 8), ink);
    else
        drawing.area({place + Eigen::Vector2d(0, -5), place + Eigen::Vector2d(5, 4), place + Eigen::Vector2d(-5, 4)},
                     ink);
}

void drawSeries(Drawing& drawing, const LineSeries& series, const Points& places, std::size_t number)
{
    if (series.style != LineSeries::Style::Rings)
        drawing.line(places, series.ink, 2);
    for (const Eigen::Vector2d& place : places) {
        if (series.style == LineSeries::Style::Rings)
            drawRing(drawing, place, series.ink);
        if (series.style == LineSeries::Style::MarkedLine)
            drawMark(drawing, place, number, series.ink);
    }
}

} // namespace

Drawing drawChart(const BarChart& chart)
{
    const bool hasLimits = std::ranges::any_of(chart.rows, [](const BarRow& row) { return row.limit.has_value(); });
    double bottom = top + (chart.legend.empty() && !hasLimits ? 0 : 14);
    const double first = bottom;
    for (const BarRow& row : chart.rows)
        bottom += heightOf(row);
    Drawing drawing({barChartWidth, bottom + 44}, chart.texts.title, chart.texts.description);
    writeHeader(drawing, chart.texts);
    drawLegend(drawing, chart, hasLimits);
    const double end = barChartWidth - 70 - (hasLimits ? limitWidth : 0);
    const Scale scale(valuesOf(chart), labelWidth, end, chart.isLogarithmic);
    for (const double tick : scale.ticks())
        drawTick(drawing, scale.place(tick), first, bottom, tick);
    drawing.text({scale.middle(), bottom + 2 * lineHeight}, chart.texts.unit, Letters::Soft, Anchor::Middle);
    double y = first;
    for (const BarRow& row : chart.rows) {
        drawRow(drawing, row, scale, y);
        y += heightOf(row);
    }
    drawing.line({{labelWidth, first}, {labelWidth, bottom}}, ChartInk::Axis);
    return drawing;
}

Drawing drawChart(const LineChart& chart)
{
    std::vector<double> xs, ys;
    std::size_t longestName = 0;
    for (const LineSeries& series : chart.series) {
        longestName = std::max(longestName, charactersOf(series.name));
        for (const Eigen::Vector2d& point : series.points) {
            xs.push_back(point.x());
            ys.push_back(point.y());
        }
    }
    const double left = 84, right = chart.size.x() - 36 - letterWidth * 1.1 * static_cast<double>(longestName);
    const double upper = top + 14, bottom = chart.size.y() - 50;
    const Scale across(xs, left, right, true), up(ys, bottom, upper, true);
    Drawing drawing(chart.size, chart.texts.title, chart.texts.description);
    writeHeader(drawing, chart.texts);
    for (const double x : placesAcross(chart, across))
        drawTick(drawing, across.place(x), upper, bottom, x);
    for (const double tick : up.ticks()) {
        drawing.line({{left, up.place(tick)}, {right, up.place(tick)}}, ChartInk::Grid);
        drawing.text({left - 8, up.place(tick) + 4}, tickText(tick), Letters::Soft, Anchor::Right);
    }
    drawing.text({across.middle(), bottom + 2 * lineHeight + 2}, chart.across, Letters::Soft, Anchor::Middle);
    drawing.text({side, upper - 6}, chart.texts.unit, Letters::Soft);
    std::vector<double> ends;
    for (std::size_t number = 0; number < chart.series.size(); ++number) {
        Points places;
        for (const Eigen::Vector2d& point : chart.series[number].points)
            places.emplace_back(across.place(point.x()), up.place(point.y()));
        std::ranges::sort(places, {}, [](const Eigen::Vector2d& place) { return place.x(); });
        drawSeries(drawing, chart.series[number], places, number);
        if (!chart.series[number].name.empty())
            ends.push_back(places.empty() ? bottom : places.back().y());
    }
    ends = spread(ends, bottom);
    auto end = ends.begin();
    for (std::size_t number = 0; number < chart.series.size(); ++number) {
        const LineSeries& series = chart.series[number];
        if (series.name.empty())
            continue;
        drawSeries(drawing, series, {{right + 6, *end}, {right + 22, *end}}, number);
        drawing.text({right + 30, *end++ + 4}, series.name);
    }
    return drawing;
}

} // namespace tetra
