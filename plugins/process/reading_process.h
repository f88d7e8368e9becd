// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/exchange.h"
#include "plugins/process/findings.h"

#include <tan/base.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

/// A program in which a library reads files for a reader, in a process of its own: because the library breaks down on
/// many a damaged file, prints, or takes long to load. Whatever happens there is an Error here (answerRequests() in
/// reading_program.h is its other end).
struct ReadingProgram {
    std::filesystem::path path;
    std::string library{};  ///< whose name messages give it: "VTK"
    Message notInstalled{}; ///< a sentence for a program that is missing: what to install
    Message install{};      ///< a sentence for libraries that it lacks: how to install them
    Message otherwise{};    ///< a sentence for files that it breaks down on: what to do
    /// Words of its environment beside this process's own: "NAME=value".
    std::vector<std::string> environment{};
    std::vector<std::string> arguments{}; ///< before the request, as of an interpreter
};

using ReadAnswer = std::variant<FileFindings, FileContents>;

/// Where a program of this name lies that is installed beside the plugin in which `symbol` is.
std::filesystem::path programBesidePlugin(const void* symbol, const std::string& name);

/// A request as the program gets it.
template <class Request> std::string requestText(Request request)
{
    std::string text;
    ExchangeOutput output([&](const void* data, std::size_t bytes) {
        text.append(static_cast<const char*>(data), bytes);
        return true;
    });
    exchange(output, request);
    return text;
}

/// Runs the program on a request about `file` and waits for its answer. Cancelling ends the process at once. It limits
/// its own memory and time (process_limits.h); it is ended if for `idle` it neither worked nor said anything, as on a
/// disk that does not answer. Errors: the program's own; a limit that it met; it is not installed (with what to
/// install); no memory or files to start it; it crashed. Any thread.
Result<ReadAnswer> askReadingProgram(const ReadingProgram& program, const std::string& request, const std::string& file,
                                     const Progress& progress,
                                     std::chrono::milliseconds idle = std::chrono::minutes(10));

} // namespace tetra
