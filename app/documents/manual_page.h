// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/documents/documented_program.h"

#include <span>
#include <string>

namespace tetra {

/// The manual page tan(1) as roff, in UTF-8: what `tan --help` and `tan SUBCOMMAND --help` say.
std::string manualPage(std::span<const DocumentedSubcommand> subcommands);

} // namespace tetra
