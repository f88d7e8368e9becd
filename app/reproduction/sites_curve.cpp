// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/sites_curve.h"

#include <tan/query.h>

#include <cmath>

namespace tetra {

Points sitesCurve(const Model& model)
{
    Points points;
    for (double exponent = 1; exponent >= -2; exponent -= 0.05) {
        const double percent = std::pow(10, exponent);
        const MeshSize size = meshSizeAt(model, {.error = percent, .warping = percent});
        points.emplace_back(percent, size.sites);
    }
    return points;
}

} // namespace tetra
