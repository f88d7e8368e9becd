// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored_volume.h"

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// Reads a text of `numbers` numbers with blanks or ends of lines between them, as MetaImages have it, and keeps those
/// from `skip` on that `kept` has room for, as numbers of `type` in the byte order of this machine. The last number
/// must have a blank or an end of line behind it too, or a part of it may be missing; what follows is not looked at.
/// Errors: fewer numbers, or one that the type cannot hold; cancelled. Linear.
Status readStoredText(std::string_view text, StoredType type, std::uint64_t numbers, std::uint64_t skip,
                      std::span<std::byte> kept, const Progress& progress);

} // namespace tetra
