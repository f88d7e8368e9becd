// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/unit_powers.h"

#include <tan/base.h>

#include <algorithm>

namespace tetra {
namespace {

/// "m^2", "s", with a blank before what is not the first.
void multiply(std::string& product, std::string_view unit, double power)
{
    product += (product.empty() ? "" : " ") + std::string(unit) + (power == 1 ? "" : "^" + formatNumber(power));
}

} // namespace

std::string unitOfPowers(std::span<const std::string_view> units, std::span<const double> powers)
{
    std::string above, below;
    std::size_t factorsBelow = 0;
    for (std::size_t at = 0; at < std::min(units.size(), powers.size()); ++at) {
        if (powers[at] > 0)
            multiply(above, units[at], powers[at]);
        if (powers[at] < 0)
            multiply(below, units[at], -powers[at]);
        factorsBelow += powers[at] < 0 ? 1 : 0;
    }
    if (below.empty())
        return above;
    return (above.empty() ? "1" : above) + "/" + (factorsBelow > 1 ? "(" + below + ")" : below);
}

} // namespace tetra
