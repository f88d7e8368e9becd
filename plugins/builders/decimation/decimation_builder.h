// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

namespace tetra {

/// Half-edge collapse of irregular meshes, and of lattices and curvilinear grids cut into tetrahedra, judged by the
/// exact error and warping that result (R11, R12, S11-S13). Memory for the whole mesh; one thread.
class DecimationBuilder : public Builder {
public:
    /// Its reason says how much memory the build takes; a score of 0 where this machine has not so much.
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
};

} // namespace tetra
