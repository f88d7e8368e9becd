// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// Writes the places of the numbers in [least, largest] to `out`, ascending, and returns the end of them. `out` has
/// room for one for each number and selectionOverrun more: which numbers are selected follows no pattern that a
/// processor could predict, so every place is written, and the next one goes over it.
using NumberSelection = std::uint32_t* (*)(std::span<const std::uint32_t> numbers, std::uint32_t least,
                                           std::uint32_t largest, std::uint32_t* out);
inline constexpr std::size_t selectionOverrun = 16;

struct NumberSelectionVariant {
    std::string_view name;
    NumberSelection select;
};

/// The variants that this processor can run, the fastest first; all do the same.
std::span<const NumberSelectionVariant> numberSelections();

} // namespace tetra
