// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/graphics/volume/slab_shading.h"

#include <bit>
#include <cstring>

namespace tetra {

/// Parts of a block's vectors, and several of them at a time. For use inside functions compiled for several instruction
/// sets.

template <class Lanes> TETRA_SIMD_INLINE Lanes lanesOf(const Float8& block, int first)
{
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const float*>(&block) + first, sizeof lanes);
    return lanes;
}
template <class Lanes> TETRA_SIMD_INLINE void putLanes(const Lanes& lanes, int first, Float8& block)
{
    std::memcpy(reinterpret_cast<float*>(&block) + first, &lanes, sizeof lanes);
}

/// The halves of a block's vector; through memory, as machines without such vectors have it there.
struct Halves {
    Float4 low, high;
};
TETRA_SIMD_INLINE Halves halvesOf(Float8 lanes)
{
    return std::bit_cast<Halves>(lanes);
}
TETRA_SIMD_INLINE Float8 whole(Float4 low, Float4 high)
{
    return std::bit_cast<Float8>(Halves{low, high});
}

} // namespace tetra
