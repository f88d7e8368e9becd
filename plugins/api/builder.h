// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/data/dataset.h"
#include "core/mesh/history.h"
#include "plugins/api/parameter.h"

#include <QtPlugin>

namespace tetra {

/// How well a plugin suits an input: 0 not at all, 1 made for it. `reason` says why, in a sentence for the user.
struct Acceptance {
    double score = 0;
    std::string reason;
};

/// What a build made.
struct BuildReport {
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived; a model leaves out those that no query can give
    std::uint64_t inverted = 0;   ///< cells left flipped in the finest mesh (S5)
    std::uint64_t degenerate = 0; ///< cells without volume (S6)
};

/// Where a build puts what it makes.
struct BuildTarget {
    HistorySink& history;
};

/// Makes a multiresolution history out of a dataset (R8, R11). Runs on a worker thread; touches no widget and no GL.
class Builder {
public:
    virtual ~Builder() = default;
    virtual Acceptance accepts(const Dataset& dataset) const = 0;
    virtual std::vector<Parameter> parameters() const = 0;
    /// Hands the history to `target`, coarse first, and ends with its finish(). Stops within a second when cancelled.
    virtual Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                      const Progress& progress) const = 0;
};

} // namespace tetra

#define TAN_BUILDER_INTERFACE "org.tan.Builder/1"
Q_DECLARE_INTERFACE(tetra::Builder, TAN_BUILDER_INTERFACE)
