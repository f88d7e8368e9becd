// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/data.h>

#include <vector>

namespace tetra {

/// An isovalue to add to `existing`: in the middle of the widest part of `range` that has none, in the first of the
/// distinct colours (tan/render.h) that is not in use. Translucent unless it is the only one.
Isovalue nextIsovalue(const std::vector<Isovalue>& existing, const ValueRange& range);

} // namespace tetra
