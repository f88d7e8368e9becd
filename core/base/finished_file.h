// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>

// Files that are finished before they get their name: what another program made, or what has to be looked at first.
// They take it as what a FileWriter writes does (file_writer.h).

namespace tetra {

/// Whether a FileWriter would replace what is there, or make it; else its error. Makes nothing.
Status checkTarget(const std::filesystem::path& target);

/// Gives a finished file on the same disk the name of `target`, as commit() does: synced, with the permissions of what
/// was there, and never over what a FileWriter refuses. Errors: as FileWriter's; then `made` stays.
TAN_INTERNAL Status replaceFile(const std::filesystem::path& made, const std::filesystem::path& target);

} // namespace tetra
