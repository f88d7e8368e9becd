// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/documents/documented_program.h"

#include <span>
#include <string>

namespace tetra {

/// What the shells need to complete the subcommands of `tan`, their options and the values that can be listed; file
/// names everywhere else. As of the plugins that are part of the program.
std::string bashCompletion(std::span<const DocumentedSubcommand> subcommands);
std::string zshCompletion(std::span<const DocumentedSubcommand> subcommands);
std::string fishCompletion(std::span<const DocumentedSubcommand> subcommands);

} // namespace tetra
