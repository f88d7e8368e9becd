// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// How well a plugin suits an input: 0 not at all, 1 made for it. `reason` says why, in a sentence for the user.
struct Acceptance {
    double score = 0;
    Message reason;
};

/// What the needs of a build follow from.
struct BuildSize {
    DomainClass domain = DomainClass::RegularLattice;
    std::uint64_t points = 0;
    std::uint64_t tetrahedra = 0; ///< of irregular data
    bool convex = false;          ///< Dataset::convex
    SampleType type = SampleType::Float32;
    SiteDensity density{}; ///< of the sites that are needed; unknown before the data are read: the worst case
};

/// What building a model takes, within a factor of two of what was measured (docs/lab/performance.md); the time on a
/// processor of 2021.
struct BuildEstimate {
    std::uint64_t memoryBytes = 0; ///< at its peak, with the program and what it holds of the data
    std::uint64_t diskBytes = 0;   ///< at its peak, work files and model together; not what `--resume` writes besides
    std::uint64_t modelBytes = 0;
    double seconds = 0;
};

/// What a build can do beside building.
struct BuildAbilities {
    bool usesThreads = false; ///< more than one
    bool resumes = false;     ///< goes on with what an interrupted build left (BuildTarget::resume)
    bool keeps = true;        ///< what is finished when it is cancelled can become a model: the history is handed over
                              ///< while it runs, or then (BuildTarget::keepWhenCancelled)
    bool takesParts = false;  ///< is cut into parts (BuildTarget::part)
};

/// Makes a multiresolution history out of a dataset (R8, R11). Runs on a worker thread; touches no widget and no GL.
class Builder {
public:
    virtual ~Builder() = default;
    virtual Acceptance accepts(const Dataset& dataset) const = 0;
    virtual std::vector<Parameter> parameters() const = 0;
    /// The values of parameters() by which the model's finest mesh has an error of no more than `percent` of the range
    /// (and a warping likewise, of the diagonal), so that the model is smaller; 0 keeps everything. Empty if the
    /// builder has no such choice.
    virtual ParameterValues detail(double /*percent*/, DomainClass /*domain*/) const { return {}; }
    /// Of a build of this dataset with these values. Quick.
    virtual BuildAbilities abilities(const Dataset& /*dataset*/, const ParameterValues& /*values*/) const { return {}; }
    /// Nothing if that is not known, or if it does not take data of this domain. `threads`: that the build may use,
    /// positive. Quick.
    virtual std::optional<BuildEstimate> estimate(const BuildSize& /*size*/, const ParameterValues& /*values*/,
                                                  unsigned /*threads*/) const
    {
        return std::nullopt;
    }
    /// The dataset as build() takes it and as the model has it, such as the points of a convex mesh: `dataset` itself
    /// unless the builder makes another one of it.
    virtual Result<Dataset> taken(const Dataset& dataset, const ParameterValues& /*values*/,
                                  const Progress& /*progress*/) const
    {
        return dataset;
    }
    /// Of a dataset that taken() gave. Hands the history to `target`, coarse first, and ends with its finish(). Stops
    /// within a second when cancelled.
    virtual Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                      const Progress& progress) const = 0;
    /// `values` with its decision in place of each word that leaves one to the builder, as the model keeps it: what is
    /// claimed of a model follows from there. The other functions take either. Quick.
    virtual ParameterValues settled(const Dataset& /*dataset*/, const ParameterValues& values) const { return values; }
};

} // namespace tetra
