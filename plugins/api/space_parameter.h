// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

inline constexpr std::string_view physicalSpace = Message::marked("physical");
inline constexpr std::string_view computationalSpace = Message::marked("computational");

/// In which space builders take grids. For data of these domains only, by domainNameOf().
inline Parameter spaceParameter(std::vector<std::string> domains)
{
    Parameter space;
    space.id = "space";
    space.label = Message::marked("Space");
    space.explanation = Message::marked(
        "For grids whose points lie anywhere: 'physical' builds where they lie, by decimation from the mesh of the "
        "grid's cells, or by refinement (of rectilinear grids) from the points alone; 'computational' by their "
        "indices, as the paper did, which takes less memory and supports blocks.");
    space.defaultValue = std::string(physicalSpace);
    space.choices = {std::string(physicalSpace), std::string(computationalSpace)};
    space.onlyWith.id = domainId;
    space.onlyWith.values.assign(domains.begin(), domains.end());
    return space;
}

} // namespace tetra
