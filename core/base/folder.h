// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace tetra {

/// The paths of all that is in a folder, "" being the current one, in no order; `problem` says why some are missing.
/// Throws std::bad_alloc if memory runs out: std::filesystem's own iterators would end the program (libstdc++ 12).
std::vector<std::filesystem::path> pathsIn(const std::filesystem::path& folder, std::error_code& problem);

} // namespace tetra
