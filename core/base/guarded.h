// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <new>
#include <string>
#include <string_view>

namespace tetra {

/// What `work` returns, a Result or a Status. Memory that is not to be had becomes an Error, "Not enough memory to "
/// and the purpose: for the functions of the face, which do not throw.
template <class Work> auto guarded(std::string_view purpose, const Work& work) -> decltype(work())
try {
    return work();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 Message::say("Not enough memory to %1. Close other programs, or take fewer samples.", purpose)};
}

} // namespace tetra
