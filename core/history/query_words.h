// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/query.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tetra {

// The words for the choices of a query, in options, in questions to a server and in sessions, by the number of the
// choice.
inline constexpr std::array methodWords = {"automatic", "closed-set", "insertion"};
inline constexpr std::array borderWords = {"intersecting", "contained", "clipped"};

template <class Choice, std::size_t count>
constexpr const char* wordOf(const std::array<const char*, count>& words, Choice choice)
{
    return words[static_cast<std::size_t>(choice)];
}

/// The choice that a word is for, if any.
template <class Choice, std::size_t count>
constexpr std::optional<Choice> choiceOf(const std::array<const char*, count>& words, std::string_view word)
{
    const auto found = std::ranges::find(words, word, [](const char* one) { return std::string_view(one); });
    return found == words.end() ? std::nullopt : std::optional(static_cast<Choice>(found - words.begin()));
}

} // namespace tetra
