// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/transfer.h>

#include <algorithm>
#include <cmath>

namespace tetra {

std::uint64_t ValueHistogram::highest() const noexcept
{
    return counts.empty() ? 0 : *std::ranges::max_element(counts);
}

ValueHistogram valueHistogram(std::span<const float> values, double least, double largest, int parts)
{
    ValueHistogram histogram{least, largest, {}};
    const double extent = largest - least;
    if (!(extent >= 0) || !std::isfinite(extent) || parts <= 0)
        return histogram;
    histogram.counts.resize(static_cast<std::size_t>(parts));
    const double partsPerUnit = extent > 0 ? parts / extent : 0;
    const auto last = static_cast<std::size_t>(parts) - 1;
    for (const float value : values)
        if (value >= least && value <= largest)
            ++histogram.counts[std::min(last, static_cast<std::size_t>((value - least) * partsPerUnit))];
    return histogram;
}

ValueHistogram logarithmicHistogram(std::span<const float> values, double least, double largest, int parts)
{
    if (!(least > 0))
        return {};
    std::vector<float> logarithms;
    logarithms.reserve(values.size());
    for (const float value : values)
        logarithms.push_back(std::log(value));
    // The ends are rounded as the values are, so that none of the values at the ends is lost.
    return valueHistogram(logarithms, std::log(static_cast<float>(least)), std::log(static_cast<float>(largest)),
                          parts);
}

double barHeight(std::uint64_t count, std::uint64_t highest, bool logarithmic) noexcept
{
    if (highest == 0)
        return 0;
    const auto part = static_cast<double>(std::min(count, highest));
    const auto whole = static_cast<double>(highest);
    return logarithmic ? std::log1p(part) / std::log1p(whole) : part / whole;
}

} // namespace tetra
