// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <new>

namespace tetra {

/// What `work` returns, a Result or a Status; where there is not enough memory for it, an Error with this sentence and
/// its arguments, which says what the memory was for and how to need less. For the outermost functions that return a
/// Result: they do not throw.
///
///     return guarded(Message::marked("Not enough memory to read '%1'. Close other programs."),
///                    [&] { return readAll(path); }, path.native());
template <class Work, class... Arguments>
auto guarded(MarkedText sentence, const Work& work, const Arguments&... arguments) -> decltype(work())
try {
    return work();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, Message::say(sentence.text, arguments...)};
}

} // namespace tetra
