// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tetra {

/// How much lies in each of some equal parts of a range, of intervals of constant density. O(1) for each interval:
/// whole parts are counted by where the density begins and ends, the two at the ends directly.
class IntervalSums {
public:
    explicit IntervalSums(std::size_t parts) : amounts_(parts), steps_(parts + 1) {}

    /// `amount`, spread over [begin, end] in parts from 0; what lies outside is left out.
    void add(double begin, double end, double amount)
    {
        const auto count = static_cast<double>(amounts_.size());
        if (!(end >= 0 && begin <= count))
            return;
        if (end - begin < leastExtent) {
            amounts_[partOf(begin)] += amount;
            return;
        }
        const double density = amount / (end - begin);
        begin = std::max(begin, 0.0);
        end = std::min(end, count);
        const std::size_t first = partOf(begin), last = partOf(end);
        if (first == last) {
            amounts_[first] += density * (end - begin);
            return;
        }
        amounts_[first] += density * (static_cast<double>(first + 1) - begin);
        amounts_[last] += density * (end - static_cast<double>(last));
        steps_[first + 1] += density;
        steps_[last] -= density;
    }

    std::vector<double> amounts() const
    {
        std::vector<double> result = amounts_;
        double density = 0;
        for (std::size_t part = 0; part < result.size(); ++part)
            result[part] = std::max(0.0, result[part] + (density += steps_[part]));
        return result;
    }

private:
    static constexpr double leastExtent = 1e-6;

    std::size_t partOf(double place) const
    {
        return std::min(static_cast<std::size_t>(std::max(place, 0.0)), amounts_.size() - 1);
    }

    std::vector<double> amounts_;
    std::vector<double> steps_;
};

} // namespace tetra
