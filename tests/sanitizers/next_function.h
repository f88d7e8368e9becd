// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>

namespace tetra {

/// The library's function of this (mangled) name, which one of the caller's program takes the place of. Ends the
/// program if there is none, as another release of the library may call it otherwise, or if the library would still
/// find its own.
template <class Function> Function* nextFunction(const char* name)
{
    auto* const found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
    if (found == nullptr) {
        std::fprintf(stderr, "tests/sanitizers: no library has a function %s\n", name);
        std::abort();
    }
    if (dlsym(RTLD_DEFAULT, name) == reinterpret_cast<void*>(found)) {
        std::fprintf(stderr, "tests/sanitizers: nothing takes the place of %s: is its replacement exported?\n", name);
        std::abort();
    }
    return found;
}

} // namespace tetra
