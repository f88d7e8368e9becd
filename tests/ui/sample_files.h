// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/data.h>
#include <tan/model.h>

#include <filesystem>
#include <memory>
#include <string>

namespace tetra {

/// A host of the plugins of this build.
std::unique_ptr<PluginHost> hostOfThisBuild();

/// The c60 sample with size^3 points of 8 bits.
Dataset sampleDataset(std::uint32_t size);

/// Writes the dataset as an NRRD file with its samples inside. Returns its path.
std::filesystem::path writeNrrd(const Dataset& dataset, const std::filesystem::path& folder,
                                const std::string& name = "c60.nrrd");

/// Builds the dataset's model by the refinement builder, down to `errorPercent`. Returns its path.
std::filesystem::path buildSampleModel(PluginHost& host, const Dataset& dataset, const std::filesystem::path& folder,
                                       double errorPercent = 0);

/// A model of the logarithms of that sample, of values below 1 as of 1. Returns its path.
std::filesystem::path buildLogarithmModel(PluginHost& host, std::uint32_t size, const std::filesystem::path& folder);

/// A model of that sample as a density map's, which keeps mean and standard deviation of its values. Returns its path.
std::filesystem::path buildMapModel(PluginHost& host, std::uint32_t size, const std::filesystem::path& folder);

} // namespace tetra
