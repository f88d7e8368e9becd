// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <bit>
#include <string_view>

namespace tetra {

/// The words of NRRD headers, which the description of a raw file uses, too; in any case.

/// All of the format's names for a type ("short int", "int16_t" ...), and "float32", "float64". Errors: 64-bit integers
/// and blocks, which are not read, and unknown names.
Result<SampleType> parseSampleType(std::string_view name);

/// "little" or "big".
Result<std::endian> parseByteOrder(std::string_view name);

enum class SampleEncoding { Raw, Gzip, Text };

/// Errors: hex, bzip2 and zrl, which are not read, and unknown names.
Result<SampleEncoding> parseSampleEncoding(std::string_view name);

} // namespace tetra
