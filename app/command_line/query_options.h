// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"

#include <tan/query.h>

#include <string_view>
#include <vector>

namespace tetra {

/// The options that choose a mesh of a model, the same wherever a subcommand takes them.
///
/// How accurate it is, and where: --error, --warping, --focus, --focus-error, --focus-warping, --falloff, --field,
/// --budget, --method.
std::vector<Option> fieldOptions();
/// Which part of it: --window, --border, --values.
std::vector<Option> partOptions();

/// Whether one of the fieldOptions() but --warping is given, which also goes with levels of detail.
bool asksForMesh(const Arguments& arguments);

/// What all these options ask for. Errors (WrongUsage): values that do not fit, and options that do not go together.
Result<MeshQuery> queryOf(const Arguments& arguments);

/// The parts of queryOf() that other queries take, too.
Result<std::optional<Window>> windowOf(const Arguments& arguments);
Result<std::vector<ValueRange>> valueRangesOf(const Arguments& arguments);

/// As --method takes it: "closed-set".
std::string_view methodName(VariableMethod method);

} // namespace tetra
