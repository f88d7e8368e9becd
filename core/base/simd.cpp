// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/simd.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace tetra {

namespace {

constexpr std::array allLevels = {SimdLevel::Plain, SimdLevel::Eight, SimdLevel::Sixteen};

#if defined(TETRA_SIMD_16)
#if defined(__clang__)
// clang 16 cannot be asked for a level. It can for these, and no processor has them without the rest.
bool hasEight() noexcept
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
}

bool hasSixteen() noexcept
{
    return hasEight() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#else
bool hasEight() noexcept
{
    return __builtin_cpu_supports("x86-64-v3");
}

bool hasSixteen() noexcept
{
    return __builtin_cpu_supports("x86-64-v4");
}
#endif
#endif

SimdLevel levelOfMachine() noexcept
{
#if defined(TETRA_SIMD_16)
    if (hasSixteen())
        return SimdLevel::Sixteen;
    if (hasEight())
        return SimdLevel::Eight;
#endif
    return SimdLevel::Plain;
}

} // namespace

std::span<const SimdLevel> simdLevels() noexcept
{
    static const std::size_t count = static_cast<std::size_t>(levelOfMachine()) + 1;
    return std::span(allLevels).first(count);
}

#if defined(TETRA_SIMD_16)

namespace {

SimdLevel levelToUse() noexcept
{
    constexpr std::array<std::string_view, allLevels.size()> names = {"x86-64", "x86-64-v3", "x86-64-v4"};
    const char* const asked = std::getenv("TAN_INSTRUCTION_SET");
    const auto* const named = std::ranges::find(names, std::string_view(asked != nullptr ? asked : ""));
    if (named == names.end())
        return levelOfMachine();
    return std::min(levelOfMachine(), allLevels[static_cast<std::size_t>(named - names.begin())]);
}

} // namespace

const SimdLevel chosenSimdLevel = levelToUse();

#endif

} // namespace tetra
