// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tetra {

/// One state of one file of this machine: which file it is, how long, and when it was changed last.
struct FileState {
    std::string text;           ///< device, inode, size and both times, to the nanosecond
    std::int64_t changedAt = 0; ///< when the system saw the last change, nanoseconds since 1970

    bool operator==(const FileState&) const = default;
};

/// The state that a file is in. Nothing for what is not a file, or was changed in the future, so that a later change
/// may have the same time.
std::optional<FileState> stateOf(const std::filesystem::path& path);

/// Waits until a change of the file would give it another time: file systems count in steps, of 10 ms or, where times
/// have no fractions, of 2 s. What is read from then on is of this state, as long as the file is in it. Errors:
/// cancelled.
Status waitUntilSettled(const FileState& state, const Progress& progress);

} // namespace tetra
