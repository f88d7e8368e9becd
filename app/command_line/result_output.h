// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "plugins/host/file_saving.h"

#include <tan/base.h>

#include <span>
#include <string>

namespace tetra {

/// --output of a subcommand whose result may go to standard output, and --format, which it needs then.
std::vector<Option> resultOptions(PluginHost& host, WrittenContent content);

/// Where these options say that the result goes: into a file or, with '-', into standard output. Errors (WrongUsage):
/// '-' without a format or at a terminal, a format beside a name that tells it.
Result<Destination> resultDestination(const Arguments& arguments);

/// What people and programs are told of where it went: a file's name, or "standard output" and "-".
std::string shownName(const Destination& to);
std::string nameInFigures(const Destination& to);

/// Whether these words of a subcommand that has such options ask for standard output, even if something is wrong with
/// others: then nothing but the result goes there.
bool asksForStandardOutput(std::span<const std::string> words);

} // namespace tetra
