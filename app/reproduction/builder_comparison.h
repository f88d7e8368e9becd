// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/verify.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tetra {

/// The accuracies of the paper's tables, in % of the value range and, where there is warping, of the diagonal.
inline constexpr std::array<double, 8> comparedAccuracies{4, 3, 2, 1, .5, .2, .1, 0};

/// What one builder makes of a dataset.
struct ComparedBuild {
    struct Size {
        std::uint64_t sites = 0;
        std::uint64_t tetrahedra = 0;
    };
    std::string builder;                ///< id; that of decimation in the paper's order "decimation-paper"
    std::string refusal;                ///< why it does not take the dataset; else empty
    std::shared_ptr<const Model> model; ///< null if refused; the rest is 0 then
    double seconds = 0;
    std::uint64_t bytes = 0; ///< of memory, besides what was occupied before; 0 if the system does not tell
    std::uint64_t inverted = 0;
    std::uint64_t degenerate = 0;
    std::vector<Size> sizes; ///< at comparedAccuracies
    /// The larger of error and warping, %, of its best mesh of no more sites than the first build that is there has at
    /// comparedAccuracies.
    std::vector<double> accuracies;
    /// What verify() measures of that mesh at the points of the dataset, for 1 % (C15); its sites.
    ResidualStatistics error;
    std::uint32_t measuredSites = 0;
};

/// A dataset and what the builders make of it.
struct ComparedDataset {
    std::string name;
    std::filesystem::path file; ///< within the folder of data
    ParameterValues readerValues;
    std::string skipped; ///< why there is nothing about it; else empty
    DomainClass domain = DomainClass::RegularLattice;
    std::uint64_t points = 0;
    std::vector<ComparedBuild> builds; ///< by refinement, by decimation, and by that in the paper's order
};

/// Builds models of convex, curvilinear and irregular datasets in `data` by refinement, by decimation in the exact
/// order and in the paper's (3.1.2), each to the end, into `folder`/models, and measures them at the paper's accuracies
/// (R31). What is not there, or no reader here can read, is skipped and says so. Errors: a dataset that is damaged, a
/// build that fails, cancelled.
Result<std::vector<ComparedDataset>> compareBuilders(PluginHost& host, const std::filesystem::path& data,
                                                     const std::filesystem::path& folder, const Progress& progress);

} // namespace tetra
