// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/bench_report.h"

#include <tan/query.h>

#include <memory>
#include <vector>

namespace tetra {

/// Boxes of 1 to 25 % of the domain's volume at its centre, .5 % inside and 4 % outside, as closed sets and by the
/// automatic choice, over extracting the uniform fine mesh afresh; with the tetrahedra over those of the uniform fine
/// mesh that meet the box and those of the coarse mesh that do not.
std::vector<BenchCase> focusBoxCases(const std::shared_ptr<const Model>& model, const QString& name, int repeats);

/// A field that falls off over half of the domain, isovalues, and a budget: closed sets, with sites a second.
std::vector<BenchCase> fieldCases(const std::shared_ptr<const Model>& model, const QString& name, int repeats);

} // namespace tetra
