// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/queries/mesh_query.h"

#include <optional>
#include <variant>

namespace tetra {

/// A query with a focus as two queries of one resolution each, to be blended when they are drawn (R24), where the query
/// itself asks for one conforming mesh (R25).
struct TwoResolutions {
    MeshQuery outside; ///< of the whole domain
    MeshQuery inside;  ///< of a window that holds all that is nearer to the region than `border`
    std::variant<Box, Sphere> region;
    double border = 0; ///< the focus' falloff

    bool operator==(const TwoResolutions&) const = default;
};

/// Nothing if the error does not depend on the place by a single ramp around a box or a ball, or if there is a budget:
/// what part of it either mesh should have is not said.
std::optional<TwoResolutions> twoResolutions(const MeshQuery& query);

} // namespace tetra
