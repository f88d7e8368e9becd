// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tetra {

/// What the state of the random number generator SplitMix64 grows by for each number (Steele, Lea and Flood 2014).
constexpr std::uint64_t splitMixStep = 0x9e3779b97f4a7c15u;

/// The random number of 64 bits that belongs to the state.
constexpr std::uint64_t splitMix(std::uint64_t state) noexcept
{
    std::uint64_t bits = state;
    bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
    return bits ^ bits >> 31;
}

} // namespace tetra
