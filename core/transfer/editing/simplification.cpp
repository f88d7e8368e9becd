// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/editing/simplification.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
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
    Simplifier(const TransferFunction& function, const TransferSelection& selection, const LookTolerance& tolerance)
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

EditedSelection simplified(const TransferFunction& function, const TransferSelection& selection,
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

} // namespace tetra
