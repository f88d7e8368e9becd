// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/syntax.h"
#include "plugins/host/plugin_host.h"

#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A subcommand of `tan` with all that can be said to it, the options of the plugins included.
struct DocumentedSubcommand {
    std::string name;
    Syntax syntax;
};

/// What manual page and completions are written from: the same data as `tan --help`.
std::vector<DocumentedSubcommand> documentedSubcommands(PluginHost& host);

/// The ways to write an option, the short one first: "-o", "--output".
std::vector<std::string> spellings(const Option& option);

/// The values that an option can have, where its placeholder lists them ("cpu|gl"); else nothing.
std::vector<std::string> choices(const Option& option);

/// The first sentence of a text, without its full stop.
std::string firstSentence(std::string_view text);

/// `words` with `separator` between them.
std::string joined(const std::vector<std::string>& words, std::string_view separator);

/// `text` with every character out of `special` preceded by a backslash.
std::string withBackslashes(std::string_view text, std::string_view special);

} // namespace tetra
