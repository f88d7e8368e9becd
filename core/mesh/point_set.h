// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/reserved_array.h"
#include "core/mesh/packed_lattice.h"

#include <cstdint>

namespace tetra {

/// Points of a lattice, as bits: each row along x in words of its own.
class PointSet {
public:
    /// Empty. Memory comes where there are points. Error: refused address space.
    Status start(const std::array<std::uint32_t, 3>& size)
    {
        rowWords_ = (size[0] + 63) / 64;
        rows_ = size[1];
        return words_.reserve(std::uint64_t(rowWords_) * size[1] * size[2], "the set of the mesh's points");
    }
    std::uint64_t& word(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept { return row(y, z)[x / 64]; }
    bool has(std::uint32_t x, std::uint32_t y, std::uint32_t z) const noexcept
    {
        return (row(y, z)[x / 64] >> x % 64 & 1) != 0;
    }
    void add(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept { word(x, y, z) |= 1ull << x % 64; }
    void remove(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept { word(x, y, z) &= ~(1ull << x % 64); }
    /// The words of a row: the bit x % 64 of word x / 64 is point x.
    const std::uint64_t* row(std::uint32_t y, std::uint32_t z) const noexcept
    {
        return words_.data() + (std::uint64_t(z) * rows_ + y) * rowWords_;
    }
    std::uint64_t* row(std::uint32_t y, std::uint32_t z) noexcept
    {
        return words_.data() + (std::uint64_t(z) * rows_ + y) * rowWords_;
    }

private:
    std::uint32_t rowWords_ = 1;
    std::uint32_t rows_ = 1;
    ReservedArray<std::uint64_t> words_;
};

} // namespace tetra
