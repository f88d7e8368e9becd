// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tetra {

/// The files beside `path` whose names differ from its own in the last number only, by this number: the slices of a
/// stack. `path` alone if its name has no number.
std::vector<std::filesystem::path> numberedBeside(const std::filesystem::path& path);

} // namespace tetra
