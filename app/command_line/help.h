// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/syntax.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// The line behind "Usage:" of a subcommand: "tan build IN -o MODEL [OPTIONS]".
std::string usage(std::string_view name, const Syntax& syntax);

/// What holds for all subcommands: exit codes, or those of them that are asked for, and variables of the environment,
/// each with its meaning; where figures and messages go.
std::vector<std::pair<std::string, std::string>> exitCodes();
std::vector<std::pair<std::string, std::string>> exitCodes(const std::vector<int>& codes);
std::vector<std::pair<std::string, std::string>> environmentVariables();
std::string generalRemarks();

/// What `tan --help` prints; `subcommands` are names with their purposes.
std::string programHelp(const std::vector<std::pair<std::string, std::string>>& subcommands);

/// What `tan NAME --help` prints.
std::string subcommandHelp(std::string_view name, const Syntax& syntax);

} // namespace tetra
