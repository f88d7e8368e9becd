// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tetra {

/// Functions whose results are the same bits on every machine with IEEE arithmetic, which those of the C library are
/// not: only + - * and roundings, no contraction. Correct to a few units in the last place.

/// e^x for finite x in [-700, 700]; clamped beyond, which is next to nothing or next to infinity.
double portableExponential(double x) noexcept;

/// cos(2 pi turns), for |turns| up to 2^52.
double portableCosineOfTurns(double turns) noexcept;

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
