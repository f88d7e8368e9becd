// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tetra {

/// Where the solution that belongs to a grid file may lie, the likeliest first: bluntfinxyz.bin and bluntfinq.bin, or
/// the same name ending in .q, .qsol or .sol.
std::vector<std::filesystem::path> solutionNames(const std::filesystem::path& grid);

/// Where the grid that belongs to a solution file may lie.
std::vector<std::filesystem::path> gridNames(const std::filesystem::path& solution);

/// Whether a file is called like a solution.
bool isSolutionName(const std::filesystem::path& path);

/// The first of `names` that exists; empty if none does.
std::filesystem::path firstExisting(const std::vector<std::filesystem::path>& names);

} // namespace tetra
