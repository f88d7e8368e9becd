// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/whole_elsewhere.h"

#include <tan/model.h>

namespace tetra {

/// Sizes of a model's uniform meshes, for those who do not have it: by keys that fall by a fiftieth or more from one to
/// the next, so that they are some hundreds, and tell how large the mesh of an error is to a few percent. O(log sites)
/// each.
WholeSizes sizesOfWhole(const Model& model);

} // namespace tetra
