// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/mesh_query.h"

#include <algorithm>

namespace tetra {

bool operator==(const MeshQuery& first, const MeshQuery& second)
{
    const auto sameRange = [](const ValueRange& one, const ValueRange& other) {
        return one.minimum == other.minimum && one.maximum == other.maximum;
    };
    return first.error == second.error && first.warping == second.warping && first.budget == second.budget &&
           std::ranges::equal(first.values, second.values, sameRange) && first.window == second.window &&
           first.method == second.method;
}

} // namespace tetra
