// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/data/dataset.h"

namespace tetra {

/// What a curvilinear dataset must keep whoever reads it: finite positions and values, and cells with a volume. The
/// error says what is wrong with "it".
Status checkGrid(const Dataset& dataset);

} // namespace tetra
