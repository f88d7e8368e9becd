// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace tetra {

/// A piece of somebody's file or option for a message: at most 80 bytes and no half character, what controls a terminal
/// replaced by '?'.
std::string shownText(std::string_view text);

} // namespace tetra
