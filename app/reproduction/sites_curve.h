// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/drawing.h"

#include <tan/model.h>

namespace tetra {

/// Sites against error (and, where there is one, the same warping) in %, from 10 % down to a hundredth.
Points sitesCurve(const Model& model);

} // namespace tetra
