// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/transfer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {

namespace {

constexpr double timesTheMean = 2.5;    ///< times the share of a part if all values were equally frequent
constexpr double stillBackground = 0.1; ///< of the commonest part's share
constexpr double mostOfRange = 1.0 / 8;

} // namespace

std::optional<BackgroundValues> backgroundValues(const ValueHistogram& volumes)
{
    const std::vector<std::uint64_t>& counts = volumes.counts;
    const double extent = volumes.largest - volumes.least;
    if (counts.empty() || !(extent > 0) || !std::isfinite(extent))
        return std::nullopt;
    const auto share = [&](std::size_t part) { return static_cast<double>(counts[part]); };
    const double parts = static_cast<double>(counts.size());
    const double mean = std::accumulate(counts.begin(), counts.end(), 0.0) / parts;
    const auto commonest = static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin());
    if (!(share(commonest) > timesTheMean * mean))
        return std::nullopt;
    const double least = std::max(timesTheMean * mean, stillBackground * share(commonest));
    // Grows to the side where there is more of it.
    std::size_t begin = commonest, end = commonest + 1;
    while (static_cast<double>(end - begin + 1) <= mostOfRange * parts) {
        const double below = begin > 0 ? share(begin - 1) : 0;
        const double above = end < counts.size() ? share(end) : 0;
        if (std::max(below, above) < least)
            break;
        above >= below ? ++end : --begin;
    }
    const auto valueAt = [&](double part) { return std::lerp(volumes.least, volumes.largest, part / parts); };
    // At an end of the range, where instruments cut off, it is that: of many magnitudes a part holds most.
    const double middle = commonest == 0                   ? 0
                          : commonest == counts.size() - 1 ? parts
                                                           : static_cast<double>(commonest) + 0.5;
    return BackgroundValues{valueAt(static_cast<double>(begin)), valueAt(middle), valueAt(static_cast<double>(end))};
}

} // namespace tetra
