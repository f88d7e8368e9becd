// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/data/lattice.h"
#include "plugins/api/parameter.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tetra {

/// The builder's parameter "block": "automatic", "none", or the cells along an edge of a block.
Parameter blockParameter();

/// Whether a lattice of so many points is refined in blocks, as far as that can be known of their number.
bool takesBlocks(const std::string& text, std::uint64_t points, std::uint64_t usableBytes);

/// The number of cells that `text` names, or none for "automatic" and "none". A WrongUsage error if it is none of the
/// parameter's values.
Result<std::optional<std::uint32_t>> givenBlocks(const std::string& text);

/// The cells along an edge of a block, or none to refine the lattice as a whole. `text`: the parameter's value;
/// `usableBytes`: of memory, 0 if unknown. A WrongUsage error if the text is no value or names too small blocks.
Result<std::optional<std::uint32_t>> chooseBlocks(const std::string& text, const Lattice& lattice,
                                                  std::uint64_t usableBytes);

} // namespace tetra
