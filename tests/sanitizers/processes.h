// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SANITIZE_THREAD__)

#include <cstdarg>
#include <cstdlib>
#include <sched.h>

#include <dlfcn.h>

/// For the thread sanitizer alone, to be included by a program's main source. Qt begins a process in the memory of its
/// parent (vfork). What the sanitizer notes for the child then stands for the parent, too, which is taken for one that
/// forked: it would not see the order of its threads any more. Here the child gets memory of its own. Takes the place
/// of the sanitizer's function, and calls it.
extern "C" int clone(int (*function)(void*), void* stack, int flags, void* argument, ...) noexcept
{
    using Function = int(int (*)(void*), void*, int, void*, ...);
    static auto* const call = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, "clone"));
    if (call == nullptr)
        std::abort();
    va_list more;
    va_start(more, argument);
    void* const parent = va_arg(more, void*);
    void* const storage = va_arg(more, void*);
    void* const child = va_arg(more, void*);
    va_end(more);
    return call(function, stack, flags & ~(CLONE_VM | CLONE_VFORK), argument, parent, storage, child);
}

#endif
