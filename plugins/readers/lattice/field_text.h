// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Small helpers for the text of headers and parameters; ASCII only, no locale.

/// Without blanks, tabs and line ends at both ends.
std::string_view trimmed(std::string_view text);

std::string lowerCase(std::string_view text);

/// The parts between any of `separators`, without empty ones.
std::vector<std::string_view> split(std::string_view text, std::string_view separators);

/// A file as a text.
inline std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The ending of a name in small letters, with its dot.
inline std::string extension(const std::filesystem::path& path)
{
    return lowerCase(path.extension().string());
}

} // namespace tetra
