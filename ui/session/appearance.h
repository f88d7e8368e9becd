// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/host/plugin_host.h"

#include <tan/data.h>

#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// How a mesh is drawn (R27), apart from isovalues and camera: a value. All but the mode is shared by the modes, so
/// that it stays when another one takes over.
struct Appearance {
    std::string mode; ///< id of a renderer plugin
    TransferFunction transfer;
    ParameterValues settings{}; ///< of the renderers' other parameters
    bool operator==(const Appearance&) const = default;
};

/// The setting that shows the faulty cells of the data, whatever the mode (C10).
inline constexpr const char* faultyCellsId = "faulty-cells";
bool showsFaultyCells(const Appearance& appearance);

/// The plugins that can show a model: isosurfaces, volume and both first, then others by id.
std::vector<Provided<Renderer>> renderingModes(PluginHost& host);

/// The first mode, with the defaults for the field. An irregular domain, whose shape no box tells, begins with its
/// boundary shown.
Appearance startingAppearance(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field,
                              DomainClass domain);

/// The isovalues to start with: those of the first mode that has some.
std::vector<Isovalue> startingIsovalues(const std::vector<Provided<Renderer>>& modes, const FieldExtent& field);

/// Within the range, and to be seen.
Isovalue corrected(Isovalue isovalue, const ValueRange& range);

/// What a renderer with these parameters is given: the isovalues and the transfer function that all modes share by
/// their ids (plugins/api/scene_parameters.h), all others from the settings. A setting that does not fit, of another
/// type or no choice here, is left to its default; a transfer function is that of `parameters`, which editors show.
ParameterValues rendererValues(const std::vector<Parameter>& parameters, const Appearance& appearance,
                               const std::vector<Isovalue>& isovalues);

/// Those that matter with these values.
std::vector<Parameter> matteringParameters(const std::vector<Parameter>& parameters, const ParameterValues& values);

/// The parameters for a form: those that have no panel of their own.
std::vector<Parameter> settingParameters(const std::vector<Parameter>& parameters);

/// Whether one of the parameters has this id.
bool hasParameter(const std::vector<Parameter>& parameters, std::string_view id);

/// The transfer function that is meant where only one can be: the one that all modes share, or else the renderer's
/// first one; null if there is none.
const Parameter* mainTransfer(const std::vector<Parameter>& parameters);

/// The one with the id `wanted`, or else the main one; null if there is none.
const Parameter* editedTransfer(const std::vector<Parameter>& parameters, std::string_view wanted);

/// What is chosen for the transfer function with this id; null if nobody has chosen one.
const TransferFunction* chosenTransfer(const std::string& id, const Appearance& appearance);

/// An isovalue to add to `existing`: in the middle of the widest part of `range` that has none, in the first of the
/// distinct colours (tan/render.h) that is not in use. Translucent unless it is the only one.
Isovalue nextIsovalue(const std::vector<Isovalue>& existing, const ValueRange& range);

} // namespace tetra
