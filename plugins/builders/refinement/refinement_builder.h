// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

namespace tetra {

/// Greedy Delaunay refinement of regular lattices, as a whole (R8, R12, convex class).
class RefinementBuilder : public Builder {
public:
    Acceptance accepts(const Dataset& dataset) const override;
    std::vector<Parameter> parameters() const override;
    Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                              const Progress& progress) const override;
};

} // namespace tetra
