// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"

#include <string>

namespace tetra {

/// --part, of a build that many processes share.
Option partOption();
/// --wait, for other parts.
Option waitOption();

/// 'tan build' with it: prepares the parts or builds one of them.
Result<Outcome> runPart(const Invocation& invocation, const std::string& part);

} // namespace tetra
