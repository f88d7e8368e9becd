// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/zarr/helper/zarr_array.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The volume that is taken of an array: along three axes all, along the others one number.
struct ZarrSelection {
    std::array<std::size_t, 3> axes{};    ///< those of x, y and z
    std::vector<std::uint64_t> numbers{}; ///< one an axis; those of the three are not looked at

    std::array<std::uint64_t, 3> sizeIn(const ZarrArray& array) const
    {
        return {array.shape[axes[0]], array.shape[axes[1]], array.shape[axes[2]]};
    }
};

/// Puts what a chunk has of the selection to its place among the samples, x running fastest. The chunk begins at the
/// element `first` of the array; `numbers` are those of the whole chunk as they lie there.
void copyChunk(const ZarrArray& array, const ZarrSelection& selection, const std::vector<std::uint64_t>& first,
               std::span<const std::byte> numbers, std::byte* samples);

/// The same with the fill value everywhere, in a chunk of this shape.
void fillChunk(const ZarrArray& array, const ZarrSelection& selection, const std::vector<std::uint64_t>& first,
               const std::vector<std::uint64_t>& shape, std::byte* samples);

} // namespace tetra
