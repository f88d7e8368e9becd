// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>

namespace tetra {

/// Writes a dataset with the writer that suits the name of `path` best. `values` may hold that writer's parameters and
/// no others. Errors: none suits (then: what can be written); what `values` holds does not fit; it cannot be written.
Status saveDataset(PluginHost& host, const Dataset& dataset, const std::filesystem::path& path,
                   const ParameterValues& values = {}, const Progress& progress = {});

} // namespace tetra
