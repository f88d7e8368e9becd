// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a function whose loops are worth compiling for several instruction sets, chosen when the program is loaded.
/// Left out under sanitizers, whose run time is not ready yet when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__)
#define TETRA_SIMD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TETRA_SIMD_CLONES
#endif
