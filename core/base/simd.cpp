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

SimdLevel levelOfMachine() noexcept
{
#if defined(TETRA_SIMD_16)
    if (__builtin_cpu_supports("x86-64-v4"))
        return SimdLevel::Sixteen;
    if (__builtin_cpu_supports("x86-64-v3"))
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
