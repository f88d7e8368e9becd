// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/paper_tables.h"
#include "plugins/api/parameter.h"
#include "plugins/host/plugin_host.h"

#include <tan/data.h>

#include <filesystem>
#include <optional>
#include <string>

namespace tetra {

/// How a model of the paper is made again: from which file, with which parameters, and what is not known.
struct Experiment {
    std::string variant;        ///< of several for one model of the paper: how this one differs; else empty
    std::filesystem::path file; ///< within the folder of the data
    ParameterValues readerValues;
    std::uint32_t step = 1; ///< take every step-th sample along each axis
    ParameterValues builderValues;
    std::string caveat; ///< what of the paper's data is not exactly known; empty if nothing
};

/// The experiments for a model of the paper; none if it is not one that we know how to make.
std::vector<Experiment> experimentsFor(const PaperModel& model);

/// The dataset of an experiment. Nothing if its file is not in the folder.
Result<std::optional<Dataset>> openExperiment(PluginHost& host, const Experiment& experiment,
                                              const std::filesystem::path& data, const Progress& progress);

} // namespace tetra
