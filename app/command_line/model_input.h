// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"

#include <tan/open.h>
#include <tan/query.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What the help says of a model that is read.
std::string modelExplanation();

/// A file or an address as it is printed: without what a terminal would obey, and without a password.
std::string shownInput(const std::string& place);

/// Whether a model is simply mapped, with nothing to be fetched or unpacked first.
bool isAtHand(const std::filesystem::path& place);

/// The model at a path or an address; of what is packed or on a server no more than the query needs. Of a file on a
/// server, if no option says how accurate the mesh is to be, not more than takes a moment; with --at-server it stays
/// there.
Result<FoundModel> openInput(const Invocation& invocation, const std::filesystem::path& place, const MeshQuery& query,
                             const Progress& progress);
/// The options that leave a model at its server, for commands that make a mesh of it: --at-server and --token-file.
std::vector<Option> serverOptions();
/// --token-file, for all commands that read a model.
Option tokenFileOption();
/// The token that --token-file gives; none without it. Errors: WrongUsage, also where `place` is on no server.
Result<std::string> tokenOption(const Arguments& arguments, const std::filesystem::path& place);

/// The model of a session, which may have been left at its server.
Result<FoundModel> openSessionInput(const Invocation& invocation, const std::filesystem::path& place,
                                    const Progress& progress);
/// The model at a path or an address, whole; read from there, whatever the cache has of it.
Result<FoundModel> openWholeInput(const Invocation& invocation, const std::filesystem::path& place,
                                  const Progress& progress);

/// Adds "read_part" and a line of the text if only a part of the model was read.
void tellPart(const FoundModel& found, Outcome& outcome);

} // namespace tetra
