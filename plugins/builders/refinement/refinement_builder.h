// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

namespace tetra {

/// Greedy Delaunay refinement of regular lattices and scattered points (convex class) and of curvilinear grids (R8, R9,
/// R12).
class RefinementBuilder : public Builder {
public:
    Acceptance accepts(const Dataset& dataset) const override;
    std::vector<Parameter> parameters() const override;
    ParameterValues detail(double percent, DomainClass domain) const override;
    BuildAbilities abilities(const Dataset& dataset, const ParameterValues& values) const override;
    std::optional<BuildEstimate> estimate(const BuildSize& size, const ParameterValues& values,
                                          unsigned threads) const override;
    Result<Dataset> taken(const Dataset& dataset, const ParameterValues& values,
                          const Progress& progress) const override;
    Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                              const Progress& progress) const override;
    ParameterValues settled(const Dataset& dataset, const ParameterValues& values) const override;
};

} // namespace tetra
