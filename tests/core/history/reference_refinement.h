// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/build.h>
#include <tan/data.h>

namespace tetra {

/// Greedy refinement as the paper tells it, of a small lattice, with no care for time: every point tested against every
/// tetrahedron. Shares nothing with core/mesh, so that what reads histories is tested against a second source.
/// Stops when no point's error exceeds `stopKey`.
Status refineSlowly(const Dataset& dataset, HistorySink& sink, double stopKey = 0);

} // namespace tetra
