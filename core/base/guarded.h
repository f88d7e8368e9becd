// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <new>
#include <string>

namespace tetra {

/// What `work`, which builds a model, returns: a Result or a Status. Memory that is not to be had becomes an Error: for
/// the functions of the face, which do not throw.
template <class Work> auto guarded(const Work& work) -> decltype(work())
try {
    return work();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 Message::say("Not enough memory to build a model. Close other programs, or take fewer samples.")};
}

} // namespace tetra
