// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/parameter.h>
#include <tan/render.h>
#include <tan/transfer.h>
#include <tan/view.h>

#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The setting that shows the faulty cells of the data, whatever the mode (C10).
inline constexpr const char* faultyCellsId = "faulty-cells";
TAN_INTERNAL bool showsFaultyCells(const Appearance& appearance);

/// Within the range, and to be seen.
TAN_INTERNAL Isovalue corrected(Isovalue isovalue, const ValueRange& range);

/// What a renderer with these parameters is given: the isovalues and the transfer function that all modes share by
/// their ids (tan/parameter.h), all others from the settings. A setting that does not fit, of another
/// type or no choice here, is left to its default; a transfer function is that of `parameters`, which editors show.
TAN_INTERNAL ParameterValues rendererValues(const std::vector<Parameter>& parameters, const Appearance& appearance,
                                            const std::vector<Isovalue>& isovalues);

/// Those that matter with these values.
TAN_INTERNAL std::vector<Parameter> matteringParameters(const std::vector<Parameter>& parameters,
                                                        const ParameterValues& values);

/// The parameters for a form: those that have no panel of their own.
TAN_INTERNAL std::vector<Parameter> settingParameters(const std::vector<Parameter>& parameters);

/// Whether one of the parameters has this id.
TAN_INTERNAL bool hasParameter(const std::vector<Parameter>& parameters, std::string_view id);

/// The transfer function that is meant where only one can be: the one that all modes share, or else the renderer's
/// first one; null if there is none.
TAN_INTERNAL const Parameter* mainTransfer(const std::vector<Parameter>& parameters);

/// The one with the id `wanted`, or else the main one; null if there is none.
TAN_INTERNAL const Parameter* editedTransfer(const std::vector<Parameter>& parameters, std::string_view wanted);

/// What is chosen for the transfer function with this id; null if nobody has chosen one.
TAN_INTERNAL const TransferFunction* chosenTransfer(const std::string& id, const Appearance& appearance);

/// An isovalue to add to `existing`: in the middle of the widest part of `range` that has none, in the first of the
/// distinct colours (tan/render.h) that is not in use. Translucent unless it is the only one.
TAN_INTERNAL Isovalue nextIsovalue(const std::vector<Isovalue>& existing, const ValueRange& range);

} // namespace tetra
