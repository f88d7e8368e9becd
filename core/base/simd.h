// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

// Kernels, compiled for several instruction sets: each is written once, always inlined, and called by
// dispatch<kernel>(...). Under sanitizers for the plain one only: instrumented thrice they take minutes to compile.

/// For kernels and what they call with vectors: it becomes part of what calls it, and so of its instruction set.
#define TETRA_SIMD_INLINE [[gnu::always_inline]] inline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(TETRA_ONE_INSTRUCTION_SET)
/// For functions that are written by hand for one instruction set; to be called at SimdLevel::Eight or
/// SimdLevel::Sixteen only. To choose between vectors of 8 or 16 floats, and to compare them, is slow where compilers
/// have to do it in pieces.
#define TETRA_SIMD_8 __attribute__((target("arch=x86-64-v3")))
#define TETRA_SIMD_16 __attribute__((target("arch=x86-64-v4")))
#endif

namespace tetra {

/// The instruction sets that kernels are compiled for; each has what is in those before it.
enum class SimdLevel : std::uint8_t {
    Plain,   ///< what every processor has
    Eight,   ///< vectors of 8 floats: x86-64-v3
    Sixteen, ///< vectors of 16 floats: x86-64-v4
};

/// Those that this machine has, the plain one first.
std::span<const SimdLevel> simdLevels() noexcept;

#if defined(TETRA_SIMD_16)
/// The plain one until the library's constants are there, so that kernels may be called at any time.
extern const SimdLevel chosenSimdLevel;

/// The one that kernels use: the last that this machine has, or before it the one that the environment variable
/// TAN_INSTRUCTION_SET names (x86-64, x86-64-v3, x86-64-v4), so that tests reach all of them.
inline SimdLevel simdLevel() noexcept
{
    return chosenSimdLevel;
}
#else
constexpr SimdLevel simdLevel() noexcept
{
    return SimdLevel::Plain;
}
#endif

/// Vectors of the compiler; wider ones than the machine has are done in pieces. For use inside functions only: how they
/// are passed differs between instruction sets.
using Float8 = float __attribute__((vector_size(32)));
using Float16 = float __attribute__((vector_size(64)));
using Int16 = int __attribute__((vector_size(64)));
using Float4 = float __attribute__((vector_size(16)));
using Int8 = int __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));
using Long8 = std::int64_t __attribute__((vector_size(64)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));
using Int4 = int __attribute__((vector_size(16)));
using UInt4 = unsigned __attribute__((vector_size(16)));

template <auto plain, auto... others> class Dispatch;

/// The functions that a kernel becomes a part of, one for each instruction set. Their calls are plain ones, through
/// which exceptions pass.
template <class Result, class... Arguments, Result (*plain)(Arguments...), auto... others>
class Dispatch<plain, others...> {
public:
    TETRA_SIMD_INLINE Result operator()(Arguments... arguments) const
    {
        return at(simdLevel(), static_cast<Arguments&&>(arguments)...);
    }

    TETRA_SIMD_INLINE static Result at(SimdLevel level, Arguments... arguments)
    {
#if defined(TETRA_SIMD_16)
        if (level == SimdLevel::Sixteen)
            return bySixteen(static_cast<Arguments&&>(arguments)...);
        if (level == SimdLevel::Eight)
            return byEight(static_cast<Arguments&&>(arguments)...);
#else
        static_cast<void>(level);
#endif
        return plainly(static_cast<Arguments&&>(arguments)...);
    }

private:
    [[gnu::noinline]] static Result plainly(Arguments... arguments)
    {
        return plain(static_cast<Arguments&&>(arguments)...);
    }
#if defined(TETRA_SIMD_16)
    static constexpr std::array kernels = {plain, others...};
    static_assert(kernels.size() == 1 || kernels.size() == 3);

    [[gnu::noinline]] TETRA_SIMD_8 static Result byEight(Arguments... arguments)
    {
        constexpr auto eight = kernels[kernels.size() / 2];
        return eight(static_cast<Arguments&&>(arguments)...);
    }
    [[gnu::noinline]] TETRA_SIMD_16 static Result bySixteen(Arguments... arguments)
    {
        constexpr auto sixteen = kernels.back();
        return sixteen(static_cast<Arguments&&>(arguments)...);
    }
#endif
};

/// A member function as one that takes its object.
template <auto member, class Object, class Result, class... Arguments>
TETRA_SIMD_INLINE Result callMember(Object& object, Arguments... arguments)
{
    return (object.*member)(static_cast<Arguments&&>(arguments)...);
}

template <class Object, class Result, class... Arguments, Result (Object::*member)(Arguments...)> class Dispatch<member>
    : public Dispatch<callMember<member, Object, Result, Arguments...>> {
};

template <class Object, class Result, class... Arguments, Result (Object::*member)(Arguments...) const>
class Dispatch<member> : public Dispatch<callMember<member, const Object, Result, Arguments...>> {
};

/// dispatch<kernel>(arguments...) calls a kernel as it is compiled for simdLevel(); dispatch<plain, eight,
/// sixteen>(arguments...) one of three that do the same; dispatch<...>.at(level, arguments...) that of one of
/// simdLevels(). A kernel is a function that is marked TETRA_SIMD_INLINE, or such a member function, whose object comes
/// first then. What it calls is compiled with it as far as it is inlined; kernels call one another directly. They
/// neither take nor return vectors by value: how these are passed differs between instruction sets.
template <auto kernel, auto... others> inline constexpr Dispatch<kernel, others...> dispatch{};

} // namespace tetra
