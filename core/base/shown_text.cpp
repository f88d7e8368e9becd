// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/shown_text.h"

#include <algorithm>

namespace tetra {

std::string shownText(std::string_view text)
{
    constexpr std::size_t longest = 80;
    constexpr char deleted = 127;
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80)
        --end;
    std::string shown(text.substr(0, end));
    std::ranges::replace_if(
        shown, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == deleted; }, '?');
    return end < text.size() ? shown + "..." : shown;
}

} // namespace tetra
