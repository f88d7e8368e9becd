// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <exception>
#include <optional>
#include <string>
#include <string_view>

namespace tetra {

/// What a number of errno means, without a full stop: "No such file or directory". In English under every locale: the C
/// library's own texts would come in the user's language, in the middle of an English sentence. Those that files bring
/// about can be translated, others are the library's.
TAN_INTERNAL Message systemErrorText(int error);

/// Whether a number of errno says that this process or machine has no more memory, descriptors, threads or processes:
/// then it says nothing of the file, and another file or folder would not help.
TAN_INTERNAL bool isLackOfResources(int error) noexcept;
/// The same of a text that a library or the system's loader gives in place of a number.
TAN_INTERNAL bool namesLackOfResources(std::string_view text) noexcept;

/// What to do about a lack of resources, a sentence.
inline constexpr MarkedText resourceRemedy = Message::marked("Close other programs, or raise the limit (ulimit).");

/// What to do about a file that cannot be made or grow on its disk, a sentence.
Message diskRemedy(int error);

/// An ErrorKind::OutOfResource for an exception that says no more than that the machine has no more memory, threads or
/// descriptors; nothing for others.
TAN_INTERNAL std::optional<Error> lackOfResources(const std::exception& problem);

} // namespace tetra
