// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace tetra {

/// Unpacks a block that LZF packed, the quick compression of h5py; how many bytes it became. Nothing if it is damaged
/// or `to` is too short. Linear.
std::optional<std::size_t> unpackLzf(std::span<const unsigned char> from, std::span<unsigned char> to) noexcept;

/// Lets the HDF5 library read arrays that are packed so: it is the filter 32000 of The HDF Group's list.
void registerLzfFilter();

} // namespace tetra
