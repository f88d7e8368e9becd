// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"

#include <tan/query.h>

#include <string_view>
#include <vector>

namespace tetra {

/// Two opposite corners, in any order: "x0,y0,z0,x1,y1,z1". Errors (WrongUsage) name the option.
Result<Box> parseBox(std::string_view option, std::string_view text);

/// "box:x0,y0,z0,x1,y1,z1" or "sphere:x,y,z,r".
Result<Region> parseFocus(std::string_view text);

/// --focus, --focus-error, --focus-warping and --falloff.
std::vector<Option> focusOptions();

/// The error and the warping that --error and --warping ask for outside, and the options of the focus inside.
struct FocusedFields {
    ErrorField error;
    ErrorField warping;
};
/// Without a focus they are the same everywhere. Errors (WrongUsage): what does not fit or not go together.
Result<FocusedFields> focusedFields(const Arguments& arguments, double error, double warping);

} // namespace tetra
