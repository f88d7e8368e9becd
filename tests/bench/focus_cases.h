// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/bench_report.h"

#include <tan/model.h>

#include <vector>

namespace tetra {

/// Boxes of 1 to 25 % of a lattice's volume, .5 % inside and 4 % outside, at its centre and where the fine mesh is
/// densest: extracted afresh, and dragged by 2 % of the domain a step, against a uniform extraction at .5 % into fresh
/// buffers. Further figures: the tetrahedra, and those over the ones of the uniform meshes that meet and do not meet
/// the box.
std::vector<BenchCase> measureFocus(const Model& model, const QString& name, int repeats);

} // namespace tetra
