// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetra {

/// A piece of somebody's file or option for a message: at most 80 bytes and no half character, what controls a terminal
/// replaced by '?'.
std::string shownText(std::string_view text);

/// The bytes at the front of `text` that are UTF-8 (RFC 3629); all of them, if the text is.
std::size_t utf8Bytes(std::string_view text) noexcept;

} // namespace tetra
