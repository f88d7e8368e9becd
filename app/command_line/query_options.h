// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "core/serve/served_query.h"

#include <tan/query.h>

#include <string_view>
#include <vector>

namespace tetra {

/// The options that choose a mesh of a model, one group for all subcommands that take one (C2): how accurate it is, and
/// where (--error, --warping, --focus, --focus-error, --focus-warping, --falloff, --field, --budget, --method); in
/// place of one mesh all of a range of accuracies (--range, --births, --deaths); and which part of it (--window,
/// --border, --values).
std::vector<Option> queryOptions();

/// Whether one of these but --warping is given, which also goes with levels of detail.
bool asksForMesh(const Arguments& arguments);

/// These options as the words of a query.
QueryWords queryWords(const Arguments& arguments);

/// What all these options ask for; fields take what they leave out from `present`. Errors (WrongUsage): values that do
/// not fit, and options that do not go together.
Result<MeshQuery> queryOf(const Arguments& arguments, const PresentView& present = {});

/// For queries to be checked before there is a picture: something of everything.
PresentView anyView();

} // namespace tetra
