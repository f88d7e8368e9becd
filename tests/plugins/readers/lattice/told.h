// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tetra {

/// What is told of that part: "frame: sform"; empty if nothing.
inline std::string takenOf(const std::vector<Taken>& told, TakenPart part)
{
    const auto found = std::ranges::find(told, part, &Taken::part);
    return found != told.end() ? takenText(*found).text() : "";
}

/// Whether one of the sentences has these words.
inline bool says(const std::vector<Message>& sentences, const std::string& words)
{
    return std::ranges::any_of(
        sentences, [&](const Message& sentence) { return sentence.text().find(words) != std::string::npos; });
}

} // namespace tetra
