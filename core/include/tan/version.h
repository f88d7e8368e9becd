// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/version.h: which version of the library a program was compiled with, and which one it runs with.
///
/// Until 1.0 each minor version is a library of its own, which the loader does not mistake for another one
/// (libtan-core.so.0.2); within it later patches fit programs that were compiled with earlier ones.
///
/// ~~~{.cpp}
/// #if TAN_VERSION_NUMBER < TAN_VERSION_NUMBER_OF(0, 2, 0)
/// #error "This program needs TAn 0.2."
/// #endif
///
/// /// For the answer to --version.
/// std::string versions()
/// {
///     const tetra::LibraryVersion there = tetra::libraryVersion();
///     return "compiled with TAn " TAN_VERSION ", running with " + std::to_string(there.major) + "." +
///            std::to_string(there.minor) + "." + std::to_string(there.patch);
/// }
/// ~~~

#include <tan/base.h>

// The build compares these with the version of its project.
#define TAN_VERSION_MAJOR 0
#define TAN_VERSION_MINOR 2
#define TAN_VERSION_PATCH 0
#define TAN_VERSION "0.2.0"

/// Versions as numbers that grow with them, for comparisons by the preprocessor.
#define TAN_VERSION_NUMBER_OF(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define TAN_VERSION_NUMBER TAN_VERSION_NUMBER_OF(TAN_VERSION_MAJOR, TAN_VERSION_MINOR, TAN_VERSION_PATCH)

namespace tetra {

struct LibraryVersion {
    int major = 0;
    int minor = 0;
    int patch = 0;

    bool operator==(const LibraryVersion&) const = default;
};

/// That of the library that the program runs with; the macros are those of the headers that it was compiled with.
TAN_API LibraryVersion libraryVersion() noexcept;

} // namespace tetra
