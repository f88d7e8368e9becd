// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/isovalue_defaults.h"

#include <tan/render.h>

#include <algorithm>

namespace tetra {
namespace {

bool hasColour(const Isovalue& isovalue, const Colour& colour)
{
    return isovalue.red == colour.red && isovalue.green == colour.green && isovalue.blue == colour.blue;
}

/// The first distinct colour that none has; n isovalues cannot have more than n of them.
Colour freeColour(const std::vector<Isovalue>& existing)
{
    std::size_t index = 0;
    const auto inUse = [&](const Isovalue& isovalue) { return hasColour(isovalue, distinctColour(index)); };
    while (index < existing.size() && std::ranges::any_of(existing, inUse))
        ++index;
    return distinctColour(index);
}

double middleOfWidestGap(const std::vector<Isovalue>& existing, const ValueRange& range)
{
    std::vector<double> values{range.minimum, range.maximum};
    for (const Isovalue& isovalue : existing)
        values.push_back(std::clamp(isovalue.value, range.minimum, range.maximum));
    std::ranges::sort(values);
    std::size_t widest = 1;
    for (std::size_t i = 2; i < values.size(); ++i)
        if (values[i] - values[i - 1] > values[widest] - values[widest - 1])
            widest = i;
    return values[widest - 1] + (values[widest] - values[widest - 1]) / 2;
}

} // namespace

Isovalue nextIsovalue(const std::vector<Isovalue>& existing, const ValueRange& range)
{
    Isovalue isovalue;
    isovalue.value = middleOfWidestGap(existing, range);
    isovalue.opacity = existing.empty() ? 1.0F : 0.5F; // so that it does not hide the others
    const Colour colour = freeColour(existing);
    isovalue.red = colour.red;
    isovalue.green = colour.green;
    isovalue.blue = colour.blue;
    return isovalue;
}

} // namespace tetra
