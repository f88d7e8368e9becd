// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace tetra {

/// Reads exactly as many numbers as `samples` has room for out of text; blanks, line ends and commas stand between
/// them. Integer types take whole numbers only. Errors name the number and its place: not a number, out of the type's
/// range, too few, too many, cancelled. Linear.
Status readTextSamples(std::string_view text, SampleType type, std::span<std::byte> samples, const Progress& progress);

} // namespace tetra
