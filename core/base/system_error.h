// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <exception>
#include <optional>
#include <string_view>

namespace tetra {

/// The same as isLackOfResources(), for a text that a library or the system's loader gives in place of a number.
TAN_INTERNAL bool namesLackOfResources(std::string_view text) noexcept;

/// What to do about a file that cannot be made or grow on its disk, a sentence.
Message diskRemedy(int error);

/// An ErrorKind::OutOfResource for an exception that says no more than that the machine has no more memory, threads or
/// descriptors; nothing for others.
TAN_INTERNAL std::optional<Error> lackOfResources(const std::exception& problem);

} // namespace tetra
