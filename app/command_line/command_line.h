// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <ostream>
#include <span>
#include <stop_token>
#include <string>

namespace tetra {

/// Where a run of the command line writes.
struct Streams {
    std::ostream& output;   ///< figures, and nothing else
    std::ostream& messages; ///< progress and errors
    bool messagesAreTerminal = false;
    bool resultIsOutput = false; ///< then `output` is for the result alone, and figures go to the messages
};

/// Does what `words` (without the program's name) say and gives the exit code: docs/user/command-line.md. Never throws.
int runCommandLine(std::span<const std::string> words, PluginHost& host, const Streams& streams,
                   const std::stop_token& stop = {});

/// Of a program that ends with such an error.
int exitCode(ErrorKind kind);

/// Whether `words` ask for the window: none at all, or one that is a file and no subcommand.
bool isForWindow(std::span<const std::string> words);

} // namespace tetra
