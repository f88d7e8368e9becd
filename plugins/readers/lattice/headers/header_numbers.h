// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <span>

namespace tetra {

/// A number of type T at a place of a binary header, which must hold it, written in a byte order.
template <class T> T numberAt(std::span<const std::byte> header, std::size_t place, std::endian order)
{
    assert(place + sizeof(T) <= header.size());
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), header.data() + place, sizeof(T));
    if (order != std::endian::native)
        std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

} // namespace tetra
