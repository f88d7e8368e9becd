// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/bar_axis.h"

#include "core/picture/annotations/annotation_content.h"
#include "core/picture/annotations/axis_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace tetra {
namespace {

/// What a chord may be off: maps that are read as straight pieces are right within 1/255.
constexpr double chordTolerance = 1.5 / 255;
/// Between two neighbouring points, where a chord over the logarithms is compared.
constexpr int placesBetween = 8;

struct CurvePlace {
    double value = 0;
    std::array<double, 3> colour{};
    bool isPoint = false; ///< chords end at points
};
using Curve = std::vector<CurvePlace>;

std::array<double, 3> colourOf(const ColourPoint& point)
{
    return {point.colour[0], point.colour[1], point.colour[2]};
}

/// From one place to another, at values that are spaced by factors; the first is not added.
void addStraight(Curve& curve, const CurvePlace& to)
{
    const CurvePlace from = curve.back();
    for (int place = 1; place <= placesBetween; ++place) {
        const double share = double(place) / (placesBetween + 1);
        const double value = std::exp(std::lerp(std::log(from.value), std::log(to.value), share));
        const double part = (value - from.value) / (to.value - from.value);
        CurvePlace between{value, {}, false};
        for (std::size_t channel = 0; channel < 3; ++channel)
            between.colour[channel] = std::lerp(from.colour[channel], to.colour[channel], part);
        curve.push_back(between);
    }
    curve.push_back(to);
}

/// The colours between the ends, which are positive, as curves that end at each step.
std::vector<Curve> curvesOf(const TransferFunction& function, const TransferLimits& ends)
{
    const auto placeAt = [&](double value) {
        return CurvePlace{value, evaluateUnmasked(function, value).colour, true};
    };
    constexpr double rounding = 1e-9; // what lies nearer together is at one place, as a step is
    std::vector<Curve> curves{{placeAt(ends.least)}};
    for (const ColourPoint& point : function.colours) {
        if (point.value <= ends.least * (1 + rounding) || point.value >= ends.largest * (1 - rounding))
            continue;
        const CurvePlace place{point.value, colourOf(point), true};
        if (point.value <= curves.back().back().value * (1 + rounding))
            curves.push_back({place});
        else
            addStraight(curves.back(), place);
    }
    addStraight(curves.back(), placeAt(ends.largest));
    return curves;
}

/// How many chords between points, each as long as can be, stay within the tolerance of the curve; none if the curve
/// leaves that of two neighbours. `at` is the coordinate over which chords are straight.
template <class Coordinate> std::optional<std::size_t> chordsNeeded(const Curve& curve, Coordinate at)
{
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    std::size_t chords = 0;
    for (std::size_t from = 0; from + 1 < curve.size(); ++chords) {
        // The slopes of chords that pass all places up to here.
        std::array<double, 3> least{-unbounded, -unbounded, -unbounded}, largest{unbounded, unbounded, unbounded};
        std::optional<std::size_t> reached;
        for (std::size_t to = from + 1; to < curve.size(); ++to) {
            const double way = at(curve[to].value) - at(curve[from].value);
            bool passes = way > 0, isOpen = passes;
            for (std::size_t channel = 0; channel < 3 && isOpen; ++channel) {
                const double rise = curve[to].colour[channel] - curve[from].colour[channel];
                passes = passes && rise / way >= least[channel] && rise / way <= largest[channel];
                least[channel] = std::max(least[channel], (rise - chordTolerance) / way);
                largest[channel] = std::min(largest[channel], (rise + chordTolerance) / way);
                isOpen = least[channel] <= largest[channel];
            }
            if (!isOpen)
                break;
            if (passes && curve[to].isPoint)
                reached = to;
        }
        if (!reached)
            return std::nullopt;
        from = *reached;
    }
    return chords;
}

/// 1, 2 and 5 times powers of ten, or each `stride`-th power alone.
std::vector<double> powersOfTen(const TransferLimits& ends, int stride, std::span<const double> factors)
{
    constexpr double room = 1e-9;
    std::vector<double> ticks;
    const double last = std::floor(std::log10(ends.largest) + room);
    for (double power = std::floor(std::log10(ends.least)); power <= last; ++power)
        for (const double factor : factors)
            if (const double tick = factor * std::pow(10, power);
                std::fmod(power, stride) == 0 && tick >= ends.least * (1 - room) && tick <= ends.largest * (1 + room))
                ticks.push_back(std::clamp(tick, ends.least, ends.largest));
    return ticks;
}

/// What the ends of an axis of logarithms are the logarithms of; nothing where no number holds it.
std::optional<BarAxis> axisOfData(const BarAxis& axis)
{
    const TransferLimits ends{std::pow(10, axis.ends.least), std::pow(10, axis.ends.largest)};
    if (!axis.ofLogarithms || !(ends.least > 0 && ends.largest > ends.least && std::isfinite(ends.largest)))
        return std::nullopt;
    return BarAxis{.ends = ends, .logarithmic = true};
}

std::vector<double> valuesOf(std::vector<double> logarithms)
{
    for (double& value : logarithms)
        value = std::pow(10, value);
    return logarithms;
}

} // namespace

double BarAxis::shareOf(double value) const
{
    if (!logarithmic)
        return (value - ends.least) / (ends.largest - ends.least);
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const double first = std::log(ends.least);
    return value > 0 ? (std::log(value) - first) / (std::log(ends.largest) - first) : -unbounded;
}

double BarAxis::valueAt(double share) const
{
    return logarithmic ? std::exp(std::lerp(std::log(ends.least), std::log(ends.largest), share))
                       : std::lerp(ends.least, ends.largest, share);
}

BarAxis barAxisOf(const AnnotationContent& content)
{
    const auto& chosen = content.state.barEnds;
    const TransferLimits ends = chosen ? TransferLimits{chosen->least, chosen->largest}
                                       : TransferLimits{content.range.minimum, content.range.maximum};
    if (content.logarithms)
        return {.ends = ends, .ofLogarithms = true};
    return {.ends = ends, .logarithmic = content.transfer && followsLogarithm(*content.transfer, ends)};
}

bool followsLogarithm(const TransferFunction& function, const TransferLimits& ends)
{
    constexpr double leastFactor = 10; // the axes of less differ little, and so do the counts
    if (!(ends.least > 0 && ends.largest >= leastFactor * ends.least && std::isfinite(ends.largest)))
        return false;
    std::size_t overValues = 0, overLogarithms = 0;
    for (const Curve& curve : curvesOf(function, ends)) {
        const auto chords = chordsNeeded(curve, [](double value) { return std::log(value); });
        if (!chords)
            return false;
        overLogarithms += *chords;
        // Straight between points, it leaves no chord of two neighbours.
        overValues += chordsNeeded(curve, [](double value) { return value; }).value_or(0);
    }
    return overLogarithms < overValues;
}

std::vector<double> barTicks(const BarAxis& axis, int most)
{
    constexpr std::array all{1.0, 2.0, 5.0};
    constexpr std::array one{1.0};
    if (const auto ofData = axisOfData(axis)) {
        auto ticks = barTicks(*ofData, most);
        for (double& tick : ticks)
            tick = std::clamp(std::log10(tick), axis.ends.least, axis.ends.largest);
        return ticks;
    }
    const double decades = axis.logarithmic ? std::log10(axis.ends.largest) - std::log10(axis.ends.least) : 0;
    if (decades > 1) {
        if (auto ticks = powersOfTen(axis.ends, 1, all); std::ssize(ticks) <= most)
            return ticks;
        for (int stride = std::max(1, static_cast<int>(decades / most)); stride <= decades; ++stride)
            if (auto ticks = powersOfTen(axis.ends, stride, one); std::ssize(ticks) <= most && ticks.size() > 1)
                return ticks;
    }
    return niceTicks(axis.ends.least, axis.ends.largest, most);
}

std::vector<std::string> barTickTexts(const BarAxis& axis, const std::vector<double>& ticks, const NumberSigns& signs,
                                      const NumberFormat& format)
{
    if (const auto ofData = axisOfData(axis))
        return barTickTexts(*ofData, valuesOf(ticks), signs, format);
    if (!axis.logarithmic && format.style == NumberFormat::Style::Automatic)
        return tickTexts(ticks, signs);
    std::vector<std::string> texts;
    for (const double tick : ticks)
        texts.push_back(formattedNumber(tick, format, signs));
    return texts;
}

std::string barValueText(const BarAxis& axis, double value, const std::vector<double>& ticks, const NumberSigns& signs,
                         const NumberFormat& format)
{
    if (const auto ofData = axisOfData(axis))
        return barValueText(*ofData, std::pow(10, value), valuesOf(ticks), signs, format);
    if (format.style != NumberFormat::Style::Automatic)
        return formattedNumber(value, format, signs);
    if (!axis.logarithmic)
        return numberAmong(value, ticks, signs);
    const auto above = std::ranges::upper_bound(ticks, value);
    if (ticks.size() < 2)
        return shortNumber(value, signs);
    const auto second = std::clamp(above, ticks.begin() + 1, ticks.end() - 1);
    return numberAmong(value, {*(second - 1), *second}, signs);
}

} // namespace tetra
