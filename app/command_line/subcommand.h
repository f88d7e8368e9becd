// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "core/base/json.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>

#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// What a subcommand gets.
struct Invocation {
    const Arguments& arguments;
    PluginHost& host;
    const Progress& progress;
    std::ostream& messages; ///< for what is told while it runs, a line at a time
};

/// What a subcommand gives: the same figures twice, for programs (--json) and for people.
struct Outcome {
    JsonObject figures;
    std::string text;    ///< lines
    bool isYes = true;   ///< the answer, of a subcommand that is a question
    bool isHeard = true; ///< false: nobody reads standard output, and the program would wait for ever to say this
};

/// More sentences for "remarks", each a line of the text.
void addRemarks(std::span<const Message> remarks, Outcome& outcome);

/// Something that `tan` does. The syntax is asked for first; it may depend on the plugins that are there.
struct Subcommand {
    std::string_view name;
    Syntax (*syntax)(PluginHost& host);
    Result<Outcome> (*run)(const Invocation& invocation);
};

/// All of them, in the order of the help.
std::span<const Subcommand> subcommands();

/// All that can be said to a subcommand: its own syntax and the options that every one has.
Syntax wholeSyntax(const Subcommand& subcommand, PluginHost& host);

} // namespace tetra
