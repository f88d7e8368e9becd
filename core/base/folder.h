// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>
#include <vector>

// Reading and emptying folders where memory may run out: the functions of std::filesystem that go through a folder then
// end the program (libstdc++ 12 does it within noexcept).

namespace tetra {

/// Removes what is in a folder, all that is in folders there, too, but what is called `kept` in the folder itself.
/// Links are removed, not followed. What cannot be removed stays. Allocates nothing of ours, as lack of memory may be
/// why.
void removeContent(const std::filesystem::path& folder, std::string_view kept) noexcept;

/// How an attempt to lock an open file or folder ended.
enum class FileLock {
    Taken,     ///< this process has it until the descriptor and all its duplicates are closed
    Busy,      ///< a process that lives has it
    Gone,      ///< the name stands for another file by now, or for none: a lock on this one keeps nobody out
    Impossible ///< the file system cannot lock
};

/// A shared lock keeps out exclusive ones, an exclusive lock both.
enum class LockKind { Exclusive, Shared };

/// Locks (flock) what is open as `descriptor` and was opened by the name `path`, without waiting. Files of unfinished
/// work are locked for as long as their process lives, however it ends. So one that can be locked was left behind, and
/// since only the holder of the lock removes it, nobody removes a file that another process has just made.
FileLock lockFile(int descriptor, const std::filesystem::path& path, LockKind kind = LockKind::Exclusive) noexcept;

/// Removes the files in `folder` that processes of this user left there when they were killed: those whose names
/// `isOurs` takes for such, and that can be locked. Links are neither followed nor removed. O(entries of the folder);
/// what cannot be looked at or removed stays.
void removeLeftFiles(const std::filesystem::path& folder, const std::function<bool(std::string_view name)>& isOurs);

} // namespace tetra
