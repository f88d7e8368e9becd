// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// Reads the text of one file of a volume, all its numbers, and keeps those that `kept` has room for: from number
/// `skip` on every `step`-th, as numbers of the volume's type in the byte order of this machine. Errors: fewer numbers;
/// more, if the volume refuses a rest; one that the type cannot hold; cancelled. Linear.
Status readStoredText(std::string_view text, const StoredVolume& volume, std::uint64_t skip, std::uint64_t step,
                      std::span<std::byte> kept, const Progress& progress);

} // namespace tetra
