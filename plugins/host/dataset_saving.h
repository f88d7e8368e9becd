// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/data/dataset.h"
#include "plugins/host/plugin_host.h"

namespace tetra {

/// Writes a dataset with the writer that suits the name of `path` best. `values` may hold that writer's parameters and
/// no others. Errors: none suits (then: what can be written); what `values` holds does not fit; it cannot be written.
Status saveDataset(PluginHost& host, const Dataset& dataset, const std::filesystem::path& path,
                   const ParameterValues& values = {}, const Progress& progress = {});

} // namespace tetra
