// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"
#include "plugins/host/plugin_host.h"

#include <tan/data.h>
#include <tan/render.h>
#include <tan/view.h>

#include <vector>

namespace tetra {

/// The plugins that can show a model: isosurfaces, volume, both, focus, slices and projection first, in this
/// order, then others by id.
std::vector<Provided<Renderer>> renderingModes(PluginHost& host);

/// The first mode, with the defaults for the field. A domain whose shape no box tells, all but a lattice, begins with
/// its boundary shown.
Appearance startingAppearance(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field,
                              DomainClass domain);

/// The isovalues to start with: those of the first mode that has some.
std::vector<Isovalue> startingIsovalues(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field);

} // namespace tetra
