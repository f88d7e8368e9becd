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

namespace tetra {

/// Vectors of the compiler; wider ones than the machine has are done in pieces. For use inside functions only: how they
/// are passed differs between instruction sets.
using Float8 = float __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Int8 = int __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));
using Long8 = long __attribute__((vector_size(64)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = long __attribute__((vector_size(32)));
using Int4 = int __attribute__((vector_size(16)));

} // namespace tetra
