// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <string_view>

namespace tetra {

/// The bytes at the front of `text` that are UTF-8 (RFC 3629); all of them, if the text is.
std::size_t utf8Bytes(std::string_view text) noexcept;

} // namespace tetra
