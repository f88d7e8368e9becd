// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>

#include <bit>
#include <string_view>

namespace tetra {

/// The words of NRRD headers, which the description of a raw file uses, too; in any case.

/// All of the format's names for a type ("short int", "int16_t" ...), and "float32", "float64". Errors: blocks, which
/// are not read, and unknown names.
Result<StoredType> parseStoredType(std::string_view name);

/// "little" or "big".
Result<std::endian> parseByteOrder(std::string_view name);

/// Errors: hex, bzip2 and zrl, which are not read, and unknown names.
Result<StoredPacking> parsePacking(std::string_view name);

} // namespace tetra
