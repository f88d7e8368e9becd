// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// The candidate that was probably meant by `word`: the one with the fewest letters inserted, left out or exchanged,
/// if these are no more than a third of its length (but one always may be).
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

} // namespace tetra
