// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// The files beside `path` whose names differ from its own in the last number only, by this number. `path` alone if its
/// name has no number.
std::vector<std::filesystem::path> numberedBeside(const std::filesystem::path& path);

/// A stack of files that are one slice each, as their names say.
struct SliceFiles {
    std::vector<std::filesystem::path> files{}; ///< by their numbers; one if the name tells of no others
    std::vector<std::uint64_t> numbers{};       ///< of each
    /// What the names say of channels and times ("c1", "c2"), where they differ in such numbers; empty where not.
    std::vector<std::string> channels{}, times{};
    std::size_t channel = 0, time = 0; ///< in those: what the files above are of
};

/// Of the files beside `path` whose names differ from its own in their numbers only: those that differ in the number of
/// the slice alone. That is the one behind "z", "slice", "plane" or "section", or the last that stands behind none of
/// "c", "ch", "channel", "t", "time". `channel` and `time`, in the lists that this finds, take the files of others than
/// that of `path`.
SliceFiles sliceFiles(const std::filesystem::path& path, std::optional<std::size_t> channel = {},
                      std::optional<std::size_t> time = {});

} // namespace tetra
