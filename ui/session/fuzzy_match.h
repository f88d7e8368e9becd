// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace tetra {

/// How well what somebody types names `text`: each word of the query has to occur, its letters in order but not
/// necessarily side by side. More is better; nothing if it does not match. Case and accents do not matter. An empty
/// query matches everything equally. O(query * text).
std::optional<int> fuzzyMatch(const QString& query, const QString& text);

} // namespace tetra
