// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/served_sizes.h"

#include <tan/query.h>

#include <algorithm>

namespace tetra {

WholeSizes sizesOfWhole(const Model& model)
{
    constexpr double step = 0.98, leastPart = 1e-7;
    WholeSizes sizes{model.siteCount(), model.tetrahedronCount(), model.fileSize(), {}};
    const auto add = [&sizes](const MeshSize& size) {
        if (size.sites > 0 && (sizes.meshes.empty() || size.sites > sizes.meshes.back().sites))
            sizes.meshes.push_back(size);
    };
    const double extent = model.description().range.extent();
    const double weighted = model.description().warpingWeight * model.diagonal();
    const auto percent = [](double key, double whole) { return whole > 0 ? 100 * key / whole : 0; };
    const double largest = std::max(extent, weighted);
    add(meshSizeAt(model, {anyError, anyWarping}));
    double key = largest;
    while (key > leastPart * largest) {
        add(meshSizeAt(model, {percent(key, extent), weighted > 0 ? percent(key, weighted) : anyWarping}));
        key *= step;
    }
    add(meshSizeAt(model, {0, weighted > 0 ? 0 : anyWarping}));
    return sizes;
}

} // namespace tetra
