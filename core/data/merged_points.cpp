// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/merged_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace tetra {

namespace {

/// Of finite values, without a sum that could overflow.
double meanOf(double mean, double value, double count)
{
    return mean * ((count - 1) / count) + value / count;
}

} // namespace

MergedPoints mergePoints(std::vector<Eigen::Vector3d>& positions, std::vector<double>& values)
{
    MergedPoints merged;
    const auto place = [&](std::uint64_t point) {
        return std::tuple(positions[point][0], positions[point][1], positions[point][2]);
    };
    std::vector<std::uint64_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, [&](std::uint64_t a, std::uint64_t b) {
        return std::tuple_cat(place(a), std::tuple(a)) < std::tuple_cat(place(b), std::tuple(b));
    });
    std::vector<bool> superfluous(positions.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first + 1;
        const double value = values[order[first]];
        double mean = value;
        bool conflict = false;
        for (; last < order.size() && place(order[last]) == place(order[first]); ++last) {
            superfluous[order[last]] = true;
            conflict = conflict || values[order[last]] != value;
            mean = meanOf(mean, values[order[last]], static_cast<double>(last - first + 1));
        }
        merged.removed += last - first - 1;
        merged.conflicting += conflict;
        if (conflict)
            values[order[first]] = mean;
        first = last;
    }
    if (merged.removed == 0)
        return merged;
    std::size_t kept = 0;
    for (std::size_t point = 0; point < positions.size(); ++point)
        if (!superfluous[point]) {
            positions[kept] = positions[point];
            values[kept++] = values[point];
        }
    positions.resize(kept);
    values.resize(kept);
    return merged;
}

Message mergeRemark(const MergedPoints& merged)
{
    if (merged.removed == 0)
        return {};
    const Message removed =
        merged.removed == 1
            ? Message::say("1 point at the same place as another was merged with it.")
            : Message::say("%1 points at the same place as another were merged with it.", merged.removed);
    if (merged.conflicting == 0)
        return removed;
    return Message::say(
        "%1 %2", removed,
        merged.conflicting == 1
            ? Message::say("1 place had several different values and got their mean.")
            : Message::say("%1 places had several different values and got their mean.", merged.conflicting));
}

} // namespace tetra
