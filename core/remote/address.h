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

/// What of an address is wanted.
enum class AddressPart { UpToQuery, All };

/// The address without a name and password of a user: all of the rest tells one file from another. Empty for what
/// libcurl cannot take apart, and where that is left out.
std::string addressWithoutUser(std::string_view address, AddressPart part = AddressPart::All);

} // namespace tetra
