// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/render/order/cell_geometry.h"
#include "core/render/samples/sampled_field.h"
#include "core/render/volume/slab_shading.h"

#include <tan/data.h>

#include <Eigen/Core>

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace tetra {

/// What samples are between each other, at eight places at a time: trilinear. For use inside functions compiled for
/// several instruction sets.

inline constexpr int placesAtOnce = 8;

/// A place for each lane, in steps of the lattice.
struct Places {
    Float8 x, y, z;
};

/// The corners of the cells that places lie in, and how far in they are.
struct CellCornersOfPlaces {
    std::uint64_t first[placesAtOnce]; ///< the sample of the smallest indices
    Float8 x, y, z;                    ///< in [0, 1]
};

/// The cell of each place along an axis, as a float.
TETRA_SIMD_INLINE Float8 cellAlong(Float8 place, float cells)
{
    const Float8 bounded = smaller(larger(place, Float8{}), Float8{} + cells);
    const Float8 whole = __builtin_convertvector(__builtin_convertvector(bounded, Int8), Float8);
    return smaller(whole, Float8{} + (cells - 1));
}

TETRA_SIMD_INLINE void findCells(const Lattice& lattice, const Places& places, CellCornersOfPlaces& cells)
{
    const auto last = [&](std::size_t axis) { return static_cast<float>(lattice.size[axis] - 1); };
    const Float8 i = cellAlong(places.x, last(0)), j = cellAlong(places.y, last(1)), k = cellAlong(places.z, last(2));
    const Float8 ones = Float8{} + 1.0f;
    cells.x = smaller(larger(places.x - i, Float8{}), ones);
    cells.y = smaller(larger(places.y - j, Float8{}), ones);
    cells.z = smaller(larger(places.z - k, Float8{}), ones);
    const Int8 columns = __builtin_convertvector(i, Int8), rows = __builtin_convertvector(j, Int8),
               layers = __builtin_convertvector(k, Int8);
    for (int lane = 0; lane < placesAtOnce; ++lane)
        cells.first[lane] = (std::uint64_t(std::uint32_t(layers[lane])) * lattice.size[1] + std::uint32_t(rows[lane])) *
                                lattice.size[0] +
                            std::uint32_t(columns[lane]);
}

/// The samples of each lane and the ones after them.
template <class Value>
TETRA_SIMD_INLINE void loadPairs(const Value* samples, const std::uint64_t* first, Float8& here, Float8& next)
{
    if constexpr (sizeof(Value) == 1) {
        const auto pair = [&](int lane) {
            std::uint16_t two;
            std::memcpy(&two, samples + first[lane], sizeof two);
            return int(two);
        };
        const Int8 pairs = {pair(0), pair(1), pair(2), pair(3), pair(4), pair(5), pair(6), pair(7)};
        const Int8 high = std::is_signed_v<Value> ? (pairs << 16) >> 24 : pairs >> 8;
        const Int8 low = std::is_signed_v<Value> ? (pairs << 24) >> 24 : pairs & 0xff;
        here = __builtin_convertvector(low, Float8);
        next = __builtin_convertvector(high, Float8);
    } else if constexpr (sizeof(Value) == 2) {
        const auto pair = [&](int lane) {
            int two;
            std::memcpy(&two, samples + first[lane], sizeof two);
            return two;
        };
        const Int8 pairs = {pair(0), pair(1), pair(2), pair(3), pair(4), pair(5), pair(6), pair(7)};
        const Int8 high = std::is_signed_v<Value> ? pairs >> 16 : (pairs >> 16) & 0xffff;
        const Int8 low = std::is_signed_v<Value> ? (pairs << 16) >> 16 : pairs & 0xffff;
        here = __builtin_convertvector(low, Float8);
        next = __builtin_convertvector(high, Float8);
    } else {
        const auto at = [&](int lane, int more) { return samples[first[lane] + std::uint64_t(more)]; };
        here = Float8{at(0, 0), at(1, 0), at(2, 0), at(3, 0), at(4, 0), at(5, 0), at(6, 0), at(7, 0)};
        next = Float8{at(0, 1), at(1, 1), at(2, 1), at(3, 1), at(4, 1), at(5, 1), at(6, 1), at(7, 1)};
    }
}

/// The trilinear field at places.
template <class Value>
TETRA_SIMD_INLINE Float8 valuesAt(const Value* samples, const Lattice& lattice, const CellCornersOfPlaces& cells)
{
    const std::uint64_t row = lattice.size[0], layer = row * lattice.size[1];
    const auto alongRow = [&](std::uint64_t offset) __attribute__((always_inline))
    {
        Float8 here, next;
        loadPairs(samples + offset, cells.first, here, next);
        return here + cells.x * (next - here);
    };
    const Float8 front = alongRow(0), up = alongRow(row);
    const Float8 low = front + cells.y * (up - front);
    const Float8 behind = alongRow(layer), upBehind = alongRow(layer + row);
    const Float8 high = behind + cells.y * (upBehind - behind);
    return low + cells.z * (high - low);
}

/// The gradients at places, interpolated, as they are seen.
struct SeenGradients {
    Float8 right, down, away;
};

TETRA_SIMD_INLINE void gradientsAt(const SampleGradients& gradients, const Lattice& lattice,
                                   const Eigen::Matrix3f& seenFromWorld, const CellCornersOfPlaces& cells,
                                   SeenGradients& seen)
{
    using Short4 = std::int16_t __attribute__((vector_size(8)));
    const std::uint64_t row = lattice.size[0], layer = row * lattice.size[1];
    Float4 rows[placesAtOnce];
    for (int lane = 0; lane < placesAtOnce; ++lane) {
        const auto* const first = gradients.vectors.data() + cells.first[lane];
        const auto alongRow = [&](std::uint64_t offset) __attribute__((always_inline))
        {
            Short4 here, next;
            std::memcpy(&here, first + offset, sizeof here);
            std::memcpy(&next, first + offset + 1, sizeof next);
            const Float4 from = __builtin_convertvector(here, Float4);
            return from + cells.x[lane] * (__builtin_convertvector(next, Float4) - from);
        };
        const Float4 front = alongRow(0), low = front + cells.y[lane] * (alongRow(row) - front);
        const Float4 behind = alongRow(layer), high = behind + cells.y[lane] * (alongRow(layer + row) - behind);
        rows[lane] = low + cells.z[lane] * (high - low);
    }
    Float8 x, y, z, none;
    transpose(rows, x, y, z, none);
    seen.right = seenFromWorld(0, 0) * x + seenFromWorld(0, 1) * y + seenFromWorld(0, 2) * z;
    seen.down = seenFromWorld(1, 0) * x + seenFromWorld(1, 1) * y + seenFromWorld(1, 2) * z;
    seen.away = seenFromWorld(2, 0) * x + seenFromWorld(2, 1) * y + seenFromWorld(2, 2) * z;
}

} // namespace tetra
