// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/live_build.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>

#include <atomic>
#include <filesystem>
#include <optional>

namespace tetra {

/// The builder with this id, or without one the builder that accepts the dataset best. Errors: no such builder; it does
/// not accept the dataset, and why.
Result<Provided<Builder>> chooseBuilder(PluginHost& host, const Dataset& dataset,
                                        const std::optional<std::string>& id = std::nullopt);

/// What building a model took and gave.
struct ModelBuild {
    std::string builder; ///< id
    BuildReport report;
    double seconds = 0;
    std::uint64_t peakBytes = 0; ///< the most memory that this process ever occupied, the dataset included
    std::uint64_t fileBytes = 0;
    bool stoppedEarly = false;     ///< cancelled, and what was finished was kept
    std::filesystem::path model{}; ///< the file: the output, or one beside it where that would have lost a finished one
};

/// What others may do with a build while it runs. Everything outlives the build.
struct BuildControl {
    LiveBuild* live = nullptr; ///< can be looked at
    /// When the build is cancelled and this is true then, what is finished becomes a model, of less accuracy. It does
    /// not take the place of a model that is there: its name says its error then, keptName().
    const std::atomic<bool>* keepWhenCancelled = nullptr;
    /// Go on with what an interrupted build of the same model left in its work folder, and leave there what is done if
    /// this one does not end well. Else that is removed.
    bool resume = false;
    /// A folder in which the parts of this build are finished (BuildTarget::part): they are merged, and nothing is
    /// built but the model.
    std::optional<std::filesystem::path> partsIn{};
    /// How the dataset was opened: the model keeps it, so that it can be opened in the same way again.
    ImportOptions imported{};
};

/// The name of what is kept of a build of the model `output` beside that, by the error of its finest mesh in percent of
/// the value range: "engine-25-percent.tan".
std::string keptName(const std::filesystem::path& output, double error);

/// Whether there is a model `output` that a build would lose by keeping what is finished of it: any, but one that an
/// interrupted build of the same work folder had kept. Reads a small file.
bool keepsBeside(const std::filesystem::path& output);

/// Builds a model of `dataset` into `output`, which appears whole or not at all. `builderId` as in chooseBuilder();
/// `values` may hold that builder's parameters and no others. The output never replaces the dataset's own file or
/// anything that is no model (WrongUsage). Call from a worker thread; safe from any.
Result<ModelBuild> buildModel(PluginHost& host, const Dataset& dataset, const std::optional<std::string>& builderId,
                              const ParameterValues& values, const std::filesystem::path& output,
                              const Progress& progress = {}, const BuildControl& control = {});

} // namespace tetra
