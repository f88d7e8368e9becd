// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a function whose loops are worth compiling for several instruction sets, chosen when the program is loaded.
/// It must not throw, and so not allocate, unless all that calls it has nothing to clean up: GCC takes the call that
/// chooses for one that cannot throw, and ends the program where an exception meets a destructor. Left out under
/// sanitizers, whose run time is not ready yet when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__)
#define TETRA_SIMD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
/// For siblings of a function that use vectors of 8 or 16 floats, which may be called if hasSimd8() or hasSimd16(). To
/// choose between such vectors, and to compare them, is slow where compilers have to do it in pieces.
#define TETRA_SIMD_8 __attribute__((target("arch=x86-64-v3")))
#define TETRA_SIMD_16 __attribute__((target("arch=x86-64-v4")))
/// For what such functions call with vectors: it must become part of them.
#define TETRA_SIMD_INLINE [[gnu::always_inline]] inline
#else
#define TETRA_SIMD_CLONES
#define TETRA_SIMD_INLINE inline
#endif

namespace tetra {

/// Vectors of the compiler; wider ones than the machine has are done in pieces. For use inside functions only: how they
/// are passed differs between instruction sets.
using Float8 = float __attribute__((vector_size(32)));
using Float16 = float __attribute__((vector_size(64)));
using Int16 = int __attribute__((vector_size(64)));
using Float4 = float __attribute__((vector_size(16)));
using Int8 = int __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));
using Long8 = long __attribute__((vector_size(64)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = long __attribute__((vector_size(32)));
using Int4 = int __attribute__((vector_size(16)));
using UInt4 = unsigned __attribute__((vector_size(16)));

#if defined(TETRA_SIMD_16)
/// Whether this machine has what TETRA_SIMD_8 asks for.
inline bool hasSimd8() noexcept
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2") &&
           __builtin_cpu_supports("lzcnt") && __builtin_cpu_supports("movbe") && __builtin_cpu_supports("f16c");
}

/// Whether this machine has what TETRA_SIMD_16 asks for.
inline bool hasSimd16() noexcept
{
    return hasSimd8() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#endif

} // namespace tetra
