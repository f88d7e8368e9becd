// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>

namespace tetra {

/// The library's function of this (mangled) name, which one of the caller's program takes the place of. Ends the
/// program if there is none: another release of the library may call it otherwise.
template <class Function> Function* nextFunction(const char* name)
{
    auto* const found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
    if (found == nullptr) {
        std::fprintf(stderr, "tests/sanitizers: no library has a function %s\n", name);
        std::abort();
    }
    return found;
}

} // namespace tetra
