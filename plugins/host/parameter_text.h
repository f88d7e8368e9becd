// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>

#include <string>
#include <string_view>

namespace tetra {

/// Reads a parameter's value from text, as numbers are written in C whatever the locale: "true" or "false", a whole
/// number, a number, a text, or isovalues "V[:COLOUR[:OPACITY]]" separated by commas. The error (WrongUsage) names the
/// parameter and what it takes: its unit, its bounds, its choices.
Result<ParameterValue> parseParameter(const Parameter& parameter, std::string_view text);

/// The text that parseParameter() reads as this value.
std::string parameterText(const ParameterValue& value);

/// What a parameter takes, in words: "a number from 0 to 100, in %".
Message parameterDomain(const Parameter& parameter);

/// Reads one isovalue, "V[:COLOUR[:OPACITY]]". What is left out keeps the default.
Result<Isovalue> parseIsovalue(std::string_view text);

} // namespace tetra
