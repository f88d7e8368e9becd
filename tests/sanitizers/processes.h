// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SANITIZE_THREAD__)

#include "tests/sanitizers/next_function.h"

#include <cstdarg>

#include <sched.h>

/// For the thread sanitizer alone, to be included by a program's main source. Qt starts a process in its parent's
/// memory (vfork). The sanitizer notes there that it forked, so that from then on it does not see the order of the
/// parent's threads. Here the child gets memory of its own. Takes the place of the sanitizer's function, and calls it.
extern "C" int clone(int (*function)(void*), void* stack, int flags, void* argument, ...) noexcept
{
    using Function = int(int (*)(void*), void*, int, void*, ...);
    static auto* const call = tetra::nextFunction<Function>("clone");
    va_list more;
    va_start(more, argument);
    void* const parent = va_arg(more, void*);
    void* const storage = va_arg(more, void*);
    void* const child = va_arg(more, void*);
    va_end(more);
    return call(function, stack, flags & ~(CLONE_VM | CLONE_VFORK), argument, parent, storage, child);
}

#endif
