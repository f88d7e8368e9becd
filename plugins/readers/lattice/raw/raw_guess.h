// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tetra {

/// A layout that a raw file could have.
struct RawGuess {
    std::array<std::uint32_t, 3> size{};
    SampleType type = SampleType::UInt8;
};

/// Layouts that fill a file of `bytes` bytes exactly, the likeliest first, at most five: what the file's name says, as
/// in bonsai_256x256x128_uint8.raw or head_X64_Y64_Z93_u16.raw; cubes; stacks of square slices whose side is a usual
/// one.
std::vector<RawGuess> guessRawLayouts(std::string_view fileName, std::uint64_t bytes);

} // namespace tetra
