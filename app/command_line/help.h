// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/syntax.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// What `tan --help` prints; `subcommands` are names with their purposes.
std::string programHelp(const std::vector<std::pair<std::string, std::string>>& subcommands);

/// What `tan NAME --help` prints.
std::string subcommandHelp(std::string_view name, const Syntax& syntax);

} // namespace tetra
