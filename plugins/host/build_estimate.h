// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/data.h>

#include <optional>

namespace tetra {

/// The size of a dataset, with what a few thousand of its points tell of the sites that it needs (SiteDensity): some
/// milliseconds, for many points without a lattice seconds. Call from a worker thread.
BuildSize buildSizeOf(const Dataset& dataset, const Progress& progress = {});

/// Of data that are not read yet, so that no builder can be chosen: what the quickest one takes by its defaults.
/// Nothing if none knows.
std::optional<BuildEstimate> quickestEstimate(PluginHost& host, const BuildSize& size, unsigned threads);

} // namespace tetra
