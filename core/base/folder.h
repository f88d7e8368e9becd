// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

// Reading and emptying folders where memory may run out: the functions of std::filesystem that go through a folder then
// end the program (libstdc++ 12 does it within noexcept).

namespace tetra {

/// The paths of all that is in a folder, "" being the current one, in no order; `problem` says why some are missing.
/// May throw std::bad_alloc.
std::vector<std::filesystem::path> pathsIn(const std::filesystem::path& folder, std::error_code& problem);

/// Removes what is in a folder, all that is in folders there, too, but what is called `kept` in the folder itself.
/// Links are removed, not followed. What cannot be removed stays. Allocates nothing of ours, as lack of memory may be
/// why.
void removeContent(const std::filesystem::path& folder, std::string_view kept) noexcept;

} // namespace tetra
