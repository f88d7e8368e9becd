// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

namespace tetra {

/// How many times a stretch may be halved.
inline constexpr int deepestHalving = 12;
/// Places inside a stretch at which it is compared.
inline constexpr int placesCompared = 8;

/// Shares of the way from 0 to 1, both included and ascending, between which a curve may be replaced by whatever
/// `matches` compares it with: stretches are halved until matches(from, to, place) holds at places inside, or they are
/// very short.
template <class Matches> std::vector<double> adaptivePoints(const Matches& matches)
{
    std::vector<double> points{0};
    const auto divide = [&](const auto& self, double from, double to, int depth) -> void {
        bool good = true;
        for (int place = 1; good && place <= placesCompared; ++place)
            good = matches(from, to, std::lerp(from, to, place / (placesCompared + 1.0)));
        if (good || depth == deepestHalving) {
            points.push_back(to);
            return;
        }
        const double middle = std::midpoint(from, to);
        self(self, from, middle, depth + 1);
        self(self, middle, to, depth + 1);
    };
    divide(divide, 0, 1, 0);
    return points;
}

} // namespace tetra
