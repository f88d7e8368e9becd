// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// "slice%03d.raw" with its one directive for whole numbers taken apart.
struct NumberedName {
    std::string_view before, behind; ///< of the text it was made of
    std::size_t width = 0;
    char filler = ' ';

    std::string name(std::int64_t number) const;
};

/// Nothing if a text has no such directive, or several.
std::optional<NumberedName> numberedName(std::string_view text);

/// Headers that name more files than that are refused: the paths alone take a hundred megabytes.
inline constexpr std::uint64_t mostDataFiles = 1 << 18;

/// Refuses names with characters that none should have: one with a zero byte would open another file than messages
/// name.
Status checkDataFileNames(const std::vector<std::string>& names);

} // namespace tetra
