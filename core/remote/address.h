// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <string>
#include <string_view>

namespace tetra {

/// Whether a text is the address of a file on a server, http:// or https://, and no path.
TAN_INTERNAL bool isRemoteAddress(std::string_view text) noexcept;

/// The address for messages and titles: without a name and password of a user, and without what follows a '?', which
/// may be a key. Of a text that libcurl cannot take apart, such as one whose password has a '/', nothing is shown up
/// to its last '@'.
TAN_INTERNAL std::string shownAddress(std::string_view address);

/// The address without a name and password of a user, as what tells one file from another; empty for what libcurl
/// cannot take apart.
std::string addressWithoutUser(std::string_view address);

} // namespace tetra
