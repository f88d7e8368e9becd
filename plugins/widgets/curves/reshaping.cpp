// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/reshaping.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

/// With a point at the value, unless there is one.
JoinedFunction withFoot(const JoinedFunction& function, double value)
{
    const bool there = std::ranges::find(function.points, value, &TransferPoint::value) != function.points.end();
    const auto added = there ? std::nullopt : withPoint(function, value);
    return added ? added->function : function;
}

} // namespace

EditedSelection withPeak(const JoinedFunction& function, const OpacityPeak& peak, const TransferLimits& limits)
{
    const bool inside = peak.value >= limits.least && peak.value <= limits.largest;
    const double left = std::max(peak.value - peak.width / 2, limits.least);
    const double right = std::min(peak.value + peak.width / 2, limits.largest);
    if (!inside || !(peak.width > 0) || !std::isfinite(peak.opacity) || !std::isfinite(right - left) || !(left < right))
        return {function, {}};
    EditedSelection edited{withFoot(withFoot(function, left), right), {}};
    auto& points = edited.function.points;
    TransferPoint top = points.front();
    top.value = peak.value;
    top.opacity = static_cast<float>(std::clamp(peak.opacity, 0.0, 1.0));
    top.group.reset();
    const TransferSample look = evaluateUnmasked(separated(edited.function), peak.value);
    for (std::size_t channel = 0; channel < 3; ++channel)
        top.colour[channel] = std::clamp(static_cast<float>(look.colour[channel]), 0.0F, 1.0F);
    std::erase_if(points, [&](const TransferPoint& point) { return point.value > left && point.value < right; });
    if (peak.value == left || peak.value == right) {
        // Half a tent: the top is the foot at the end, on the inner side of a step that may be there.
        const auto at = peak.value == left ? std::ranges::upper_bound(points, left, {}, &TransferPoint::value) - 1
                                           : std::ranges::lower_bound(points, right, {}, &TransferPoint::value);
        at->opacity = top.opacity;
    } else {
        points.insert(std::ranges::upper_bound(points, left, {}, &TransferPoint::value), top);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool lowerSide = i + 1 < points.size() && points[i + 1].value == points[i].value;
        const bool upperSide = i > 0 && points[i - 1].value == points[i].value;
        const double value = points[i].value;
        if ((value > left && value < right) || (value == left && !lowerSide) || (value == right && !upperSide))
            edited.selection.push_back(i);
    }
    return edited;
}

namespace {

/// What a value looks like between two points, as a share of the way goes from the first to the second.
struct Stretch {
    TransferSample from, to;

    TransferSample at(double share) const
    {
        TransferSample look;
        for (std::size_t channel = 0; channel < 3; ++channel)
            look.colour[channel] = std::lerp(from.colour[channel], to.colour[channel], share);
        look.extinction = std::lerp(from.extinction, to.extinction, share);
        return look;
    }
};

class Simplifier {
public:
    Simplifier(const JoinedFunction& function, const TransferSelection& selection, const LookTolerance& tolerance)
        : points_(function.points), unit_(function.unitDistance), tolerance_(tolerance), mayGo_(points_.size())
    {
        for (const TransferPoint& point : points_)
            looks_.push_back({{point.colour[0], point.colour[1], point.colour[2]}, extinctionOf(point.opacity, unit_)});
        for (const std::size_t i : selectionOf(function, selection))
            mayGo_[i] = true;
    }

    /// The points that stay: the way of the fewest stations past all points.
    TransferSelection kept() const
    {
        const std::size_t count = points_.size();
        constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
        std::vector<std::size_t> stations(count, none), before(count, none);
        for (std::size_t i = 0; i < count && (i == 0 || mayGo_[i - 1]); ++i)
            if (isFlat(0, i, looks_[i]))
                stations[i] = 1;
        std::size_t last = none;
        for (std::size_t i = 0; i < count; ++i) {
            if (stations[i] == none)
                continue;
            for (std::size_t next = i + 1; next < count && (next == i + 1 || mayGo_[next - 1]); ++next)
                if (stations[next] > stations[i] + 1 && isStraight(i, next)) {
                    stations[next] = stations[i] + 1;
                    before[next] = i;
                }
            if (mayEndAt(i) && (last == none || stations[i] < stations[last]))
                last = i;
        }
        TransferSelection way;
        for (std::size_t i = last; i != none; i = before[i])
            way.push_back(i);
        std::ranges::reverse(way);
        return way;
    }

private:
    double opacity(double extinction) const { return -std::expm1(-extinction * unit_); }

    bool near(const TransferSample& a, const TransferSample& b) const
    {
        for (std::size_t channel = 0; channel < 3; ++channel)
            if (!(std::abs(a.colour[channel] - b.colour[channel]) <= tolerance_.colour))
                return false;
        return std::abs(opacity(a.extinction) - opacity(b.extinction)) <= tolerance_.opacity;
    }

    /// Whether the looks of points [first, last) are all near one.
    bool isFlat(std::size_t first, std::size_t last, const TransferSample& look) const
    {
        for (std::size_t i = first; i < last; ++i)
            if (!near(looks_[i], look))
                return false;
        return true;
    }

    bool mayEndAt(std::size_t point) const
    {
        for (std::size_t i = point + 1; i < points_.size(); ++i)
            if (!mayGo_[i] || !near(looks_[i], looks_[point]))
                return false;
        return true;
    }

    /// Whether two stretches, near at their ends, are so between them: of two extinctions that go straight, the
    /// opacities may differ most inside.
    bool nearBetween(const Stretch& a, const Stretch& b) const
    {
        const double riseOfA = a.to.extinction - a.from.extinction, riseOfB = b.to.extinction - b.from.extinction;
        if (!(riseOfA * riseOfB > 0) || riseOfA == riseOfB)
            return true;
        const double wanted = std::log(riseOfA / riseOfB) / unit_;
        const double share = (wanted - (a.from.extinction - b.from.extinction)) / (riseOfA - riseOfB);
        return !(share > 0 && share < 1) || near(a.at(share), b.at(share));
    }

    /// Whether the line from one point to another is near to all that lies between.
    bool isStraight(std::size_t first, std::size_t last) const
    {
        const double from = points_[first].value, extent = points_[last].value - from;
        const Stretch whole{looks_[first], looks_[last]};
        TransferSample before = looks_[first];
        for (std::size_t i = first + 1; i <= last; ++i) {
            const TransferSample line = i == last ? looks_[last] : whole.at((points_[i].value - from) / extent);
            if (!near(line, looks_[i]) || !nearBetween({looks_[i - 1], looks_[i]}, {before, line}))
                return false;
            before = line;
        }
        return true;
    }

    const std::vector<TransferPoint>& points_;
    double unit_;
    LookTolerance tolerance_;
    std::vector<bool> mayGo_;
    std::vector<TransferSample> looks_;
};

} // namespace

EditedSelection simplified(const JoinedFunction& function, const TransferSelection& selection,
                           const LookTolerance& tolerance)
{
    const TransferSelection kept = Simplifier(function, selection, tolerance).kept();
    if (kept.empty())
        return {function, selection};
    EditedSelection edited{function, {}};
    edited.function.points.clear();
    for (const std::size_t i : kept) {
        if (std::ranges::binary_search(selection, i))
            edited.selection.push_back(edited.function.points.size());
        edited.function.points.push_back(function.points[i]);
    }
    return edited;
}

namespace {

/// Of a step from nothing to full opacity over all positive numbers 1,000 are enough.
constexpr int mostPieces = 1024;

/// The largest distance of a logarithm from its chord over a factor, as a part of its rise.
double largestDeviation(double factor)
{
    const double logarithm = std::log(factor), rise = factor - 1;
    const double there = rise / logarithm;
    return std::max(0.0, std::log(there) / logarithm - (there - 1) / rise);
}

/// The optical depth of a unit distance.
double depthOf(const TransferPoint& point)
{
    return extinctionOf(point.opacity, 1);
}

int piecesBetween(const TransferPoint& from, const TransferPoint& to, const LookTolerance& tolerance)
{
    double change = std::abs(depthOf(to) - depthOf(from)) / tolerance.opacity;
    for (std::size_t channel = 0; channel < 3; ++channel)
        change = std::max(change, std::abs(double{to.colour[channel]} - from.colour[channel]) / tolerance.colour);
    const double logarithm = std::log(to.value / from.value);
    int pieces = 1;
    while (pieces < mostPieces && change / pieces * largestDeviation(std::exp(logarithm / pieces)) > 1)
        ++pieces;
    return pieces;
}

TransferPoint pointBetween(const TransferPoint& from, const TransferPoint& to, double share)
{
    TransferPoint point = from;
    point.value = from.value * std::exp(share * std::log(to.value / from.value));
    for (std::size_t channel = 0; channel < 3; ++channel)
        point.colour[channel] = std::lerp(from.colour[channel], to.colour[channel], static_cast<float>(share));
    point.opacity = static_cast<float>(-std::expm1(-std::lerp(depthOf(from), depthOf(to), share)));
    if (from.group != to.group)
        point.group.reset();
    return point;
}

} // namespace

EditedSelection withLogarithmicCourse(const JoinedFunction& function, const TransferSelection& selection,
                                      const LookTolerance& tolerance)
{
    EditedSelection edited{function, {}};
    auto& points = edited.function.points;
    points.clear();
    const auto isSelected = [&](std::size_t point) { return std::ranges::binary_search(selection, point); };
    for (std::size_t i = 0; i < function.points.size(); ++i) {
        const TransferPoint& to = function.points[i];
        if (i > 0 && isSelected(i - 1) && isSelected(i) && function.points[i - 1].value > 0 &&
            function.points[i - 1].value < to.value) {
            const TransferPoint& from = function.points[i - 1];
            const int pieces = piecesBetween(from, to, tolerance);
            for (int piece = 1; piece < pieces; ++piece) {
                const TransferPoint between = pointBetween(from, to, static_cast<double>(piece) / pieces);
                if (between.value <= points.back().value || between.value >= to.value)
                    continue; // nothing lies between numbers that are next to each other
                edited.selection.push_back(points.size());
                points.push_back(between);
            }
        }
        if (isSelected(i))
            edited.selection.push_back(points.size());
        points.push_back(to);
    }
    return edited;
}

} // namespace tetra
