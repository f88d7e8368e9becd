// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "plugins/host/plugin_host.h"

#include <optional>

namespace tetra {

/// The size of a dataset, with the share of sites that a few thousand of its points let expect: those at which the
/// field bends. O(1) for lattices, in their memory or mapped file; other data are taken to need all points.
BuildSize buildSizeOf(const Dataset& dataset);

/// Of data that are not read yet, so that no builder can be chosen: what the quickest one takes by its defaults.
/// Nothing if none knows.
std::optional<BuildEstimate> quickestEstimate(PluginHost& host, const BuildSize& size, unsigned threads);

} // namespace tetra
