// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace tetra {

/// How well what somebody types names `text`: each word of the query begins a word of the text, in any order; never are
/// its letters looked for here and there. More is better: whole words, and those from `ownStart` on, where what leads
/// to the text ends ("View: Look From: " of "View: Look From: Front") and its own name begins. Nothing if it does not
/// match. Case and accents do not matter. An empty query matches everything equally. O(query * text).
std::optional<int> wordMatch(const QString& query, const QString& text, qsizetype ownStart = 0);

} // namespace tetra
