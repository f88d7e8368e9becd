// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/model.h>

#include <QPolygonF>

namespace tetra {

/// Sites against error (and, where there is one, the same warping) in %, from 10 % down to a hundredth.
QPolygonF sitesCurve(const Model& model);

} // namespace tetra
