// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/process/parts.h"

#include <algorithm>

namespace tetra {

Error errorOfParts(const Error& error, const std::vector<std::string>& parts)
{
    constexpr std::size_t most = 20;
    if (parts.size() < 2)
        return error;
    std::string names;
    for (std::size_t part = 0; part < std::min(most, parts.size()); ++part)
        names += (part == 0 ? "" : ", ") + printable(parts[part]);
    return {error.kind, Message::say("%1 It has %2 parts, of which 'part' takes one: %3.", error.message, parts.size(),
                                     names + (parts.size() > most ? " ..." : ""))};
}

} // namespace tetra
