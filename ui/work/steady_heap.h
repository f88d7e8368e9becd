// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tetra {

/// Large arrays, of meshes and pictures, go back to the system when they are freed. Left to itself glibc soon puts them
/// between the small things that stay, such as the history of edits, and in a long session those hold on to memory many
/// times their own size. Call it once, before other threads begin.
inline void keepHeapSteady()
{
#ifdef __GLIBC__
    constexpr int large = 128 * 1024; // bytes: what glibc begins with
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
#endif
}

} // namespace tetra
