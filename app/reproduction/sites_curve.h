// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/model.h>

#include <QPointF>

#include <vector>

namespace tetra {

/// Sites against error (and, where there is one, the same warping) in %, from 10 % down to a hundredth.
std::vector<QPointF> sitesCurve(const Model& model);

} // namespace tetra
