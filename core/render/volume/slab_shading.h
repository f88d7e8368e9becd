// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/render/volume/cell_setup.h"
#include "core/render/volume/slab_integral.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tetra {

/// Light through the slabs of a cell, for several rays at once. For use inside functions compiled for several
/// instruction sets; Lanes is Float4, Float8 or Float16.

/// Beyond this optical depth nothing of a slab is seen.
inline constexpr float deepestSlab = 24;

template <class Lanes> TETRA_SIMD_INLINE Lanes smaller(Lanes a, Lanes b)
{
    return a < b ? a : b;
}
template <class Lanes> TETRA_SIMD_INLINE Lanes larger(Lanes a, Lanes b)
{
    return a > b ? a : b;
}

TETRA_SIMD_INLINE bool any(Int4 mask)
{
#if defined(__SSE2__)
    return _mm_movemask_ps((__m128)mask) != 0;
#else
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}
TETRA_SIMD_INLINE bool any(Int8 mask)
{
    return any(__builtin_shufflevector(mask, mask, 0, 1, 2, 3) | __builtin_shufflevector(mask, mask, 4, 5, 6, 7));
}

TETRA_SIMD_INLINE bool anyPositive(Float4 lanes)
{
    return any(lanes > 0.0f);
}
TETRA_SIMD_INLINE bool anyPositive(Float8 lanes)
{
    return any(lanes > 0.0f);
}
TETRA_SIMD_INLINE bool anyPositive(Float16 lanes)
{
    return anyPositive(larger(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3, 4, 5, 6, 7),
                              __builtin_shufflevector(lanes, lanes, 8, 9, 10, 11, 12, 13, 14, 15)));
}

/// What has reached the eye of some rays so far: of half a block, a block, or two.
template <class Lanes> struct Gathered {
    Lanes red, green, blue, transmittance;
};

/// The colours along a slab that no light changes: those of its segment.
struct SegmentColours {
    template <class Lanes> TETRA_SIMD_INLINE void add(Gathered<Lanes>& gathered, const ScaledSegment& segment,
                                                      Lanes valueIn, Lanes valueOut, Lanes opacity, Lanes weight) const
    {
        const Lanes value = valueIn * opacity + (valueOut - valueIn) * weight;
        gathered.red += segment.colour[0] * opacity + segment.colourPerValue[0] * value;
        gathered.green += segment.colour[1] * opacity + segment.colourPerValue[1] * value;
        gathered.blue += segment.colour[2] * opacity + segment.colourPerValue[2] * value;
    }
    /// Those of a part that begins at a share of the slab and is a share of it.
    template <class Lanes> TETRA_SIMD_INLINE SegmentColours part(Lanes, Lanes) const { return {}; }
};

/// The colours along a lit slab: affine along the ray.
template <class Lanes> struct LitColours {
    Lanes in[3], rise[3];

    TETRA_SIMD_INLINE void add(Gathered<Lanes>& gathered, const ScaledSegment&, Lanes, Lanes, Lanes opacity,
                               Lanes weight) const
    {
        gathered.red += in[0] * opacity + rise[0] * weight;
        gathered.green += in[1] * opacity + rise[1] * weight;
        gathered.blue += in[2] * opacity + rise[2] * weight;
    }
    TETRA_SIMD_INLINE LitColours part(Lanes from, Lanes share) const
    {
        LitColours some;
        for (int channel = 0; channel < 3; ++channel) {
            some.in[channel] = in[channel] + rise[channel] * from;
            some.rise[channel] = rise[channel] * share;
        }
        return some;
    }
};

/// No light on a ray's way through a cell.
struct NoLight {
    template <class Lanes>
    TETRA_SIMD_INLINE SegmentColours coloursOf(const ScaledSegment&, Lanes, Lanes, Lanes, Lanes) const
    {
        return {};
    }
    template <class Lanes> TETRA_SIMD_INLINE Lanes seenOf(Lanes length, Lanes, Lanes) const { return length; }
};

/// The light on a ray's way through a cell: what a colour is multiplied by, the highlight that is added to it, and the
/// share of the extinction that there is where it depends on the gradient. All are affine along the way.
template <class Lanes> struct LightAlong {
    Lanes factorIn, factorRise, highlightIn, highlightRise, shareIn, shareRise;

    /// The length of a slab between two shares of the way whose extinction is less in proportion: the optical depth is
    /// that of a part of it.
    TETRA_SIMD_INLINE Lanes seenOf(Lanes length, Lanes from, Lanes to) const
    {
        return length * (shareIn + shareRise * (0.5f * (from + to)));
    }

    /// The colours of a slab between two shares of the way: lit at its ends.
    TETRA_SIMD_INLINE LitColours<Lanes> coloursOf(const ScaledSegment& segment, Lanes valueIn, Lanes valueOut,
                                                  Lanes shareIn, Lanes shareOut) const
    {
        const Lanes ones = Lanes{} + 1.0f;
        const Lanes factor = factorIn + factorRise * shareIn, factorOut = factorIn + factorRise * shareOut;
        const Lanes highlight = highlightIn + highlightRise * shareIn;
        const Lanes highlightOut = highlightIn + highlightRise * shareOut;
        LitColours<Lanes> colours;
        for (int channel = 0; channel < 3; ++channel) {
            const float colour = segment.colour[channel], perValue = segment.colourPerValue[channel];
            const Lanes in = smaller((colour + perValue * valueIn) * factor + highlight, ones);
            const Lanes out = smaller((colour + perValue * valueOut) * factorOut + highlightOut, ones);
            colours.in[channel] = in;
            colours.rise[channel] = out - in;
        }
        return colours;
    }
};

/// Adds a slab whose optical depth is at most 1, or faintDepth; values count from the segment's origin.
template <bool faint, class Lanes, class Colours>
TETRA_SIMD_INLINE void addThinSlab(Gathered<Lanes>& gathered, const ScaledSegment& segment, Lanes valueIn,
                                   Lanes valueOut, Lanes length, const Colours& colours)
{
    const Lanes in = segment.halfExtinction + segment.halfExtinctionPerValue * valueIn;
    const Lanes out = segment.halfExtinction + segment.halfExtinctionPerValue * valueOut;
    const Lanes depth = larger(length * (in + out), Lanes{});
    SlabLight<Lanes> slab;
    if constexpr (faint)
        faintSlabLight(depth, length * (out - in), slab);
    else
        slabLight(depth, length * (out - in), slab);
    const Lanes opacity = slab.opacity * gathered.transmittance;
    const Lanes weight = slab.weight * gathered.transmittance;
    colours.add(gathered, segment, valueIn, valueOut, opacity, weight);
    gathered.transmittance -= opacity;
}

/// Adds a slab of any optical depth, cut into thin ones.
template <class Lanes, class Colours>
TETRA_SIMD_INLINE void addThickSlab(Gathered<Lanes>& gathered, const ScaledSegment& segment, Lanes valueIn,
                                    Lanes valueOut, Lanes length, const Colours& colours)
{
    const Lanes in = segment.halfExtinction + segment.halfExtinctionPerValue * valueIn;
    const Lanes out = segment.halfExtinction + segment.halfExtinctionPerValue * valueOut;
    float parts = 1;
    Lanes seen = Lanes{} + 1.0f; // of the slab
    for (int lane = 0; lane < static_cast<int>(sizeof(Lanes) / sizeof(float)); ++lane) {
        // With s from 0 to 1 along the slab the optical depth before s is s (atStart + s rise).
        const float atStart = std::max(2 * length[lane] * in[lane], 0.0f);
        const float rise = length[lane] * (out[lane] - in[lane]);
        float share = 1;
        if (atStart + rise > deepestSlab) {
            share = 2 * deepestSlab / (atStart + std::sqrt(std::max(atStart * atStart + 4 * rise * deepestSlab, 0.0f)));
            share = std::min(share, 1.0f);
            length[lane] *= share;
            seen[lane] = share;
            valueOut[lane] = valueIn[lane] + share * (valueOut[lane] - valueIn[lane]);
        }
        parts = std::max({parts, share * atStart, share * (atStart + 2 * share * rise)});
    }
    const float count = std::ceil(parts);
    const Lanes step = (valueOut - valueIn) * (1 / count);
    const Lanes part = length * (1 / count);
    const Lanes share = seen * (1 / count);
    for (float i = 0; i < count; ++i)
        addThinSlab<false>(gathered, segment, valueIn + i * step, valueIn + (i + 1) * step, part,
                           colours.part(i * share, share));
}

/// The slab lies between two shares of the ray's way through the cell.
template <class Lanes, class Light> TETRA_SIMD_INLINE void addSlab(Gathered<Lanes>& gathered,
                                                                   const ScaledSegment& segment, Thickness thickness,
                                                                   Lanes valueIn, Lanes valueOut, Lanes length,
                                                                   const Light& light, Lanes shareIn, Lanes shareOut)
{
    const auto colours = light.coloursOf(segment, valueIn, valueOut, shareIn, shareOut);
    length = light.seenOf(length, shareIn, shareOut);
    if (thickness == Thickness::Faint)
        addThinSlab<true>(gathered, segment, valueIn, valueOut, length, colours);
    else if (thickness == Thickness::Thin)
        addThinSlab<false>(gathered, segment, valueIn, valueOut, length, colours);
    else
        addThickSlab(gathered, segment, valueIn, valueOut, length, colours);
}

/// Adds the slabs of rays that meet a cell's segments upwards, or downwards.
template <class Lanes, class Light>
TETRA_SIMD_INLINE void addSlicesOneWay(Gathered<Lanes>& gathered, const ScaledSegment* segments, const CellSetup& cell,
                                       bool upwards, Lanes valueIn, Lanes rise, Lanes perRise, Lanes length,
                                       const Light& light)
{
    Lanes shareBefore = {};
    Lanes from = valueIn;
    for (int i = 0; i <= cell.lastSegment - cell.firstSegment; ++i) {
        const ScaledSegment& segment = segments[upwards ? cell.firstSegment + i : cell.lastSegment - i];
        const float knot = upwards ? segment.end : segment.begin;
        const Lanes share = smaller(larger((knot - valueIn) * perRise, Lanes{}), Lanes{} + 1.0f);
        const Lanes to = valueIn + share * rise;
        if (!segment.transparent)
            addSlab(gathered, segment, cell.thickness, from - segment.origin, to - segment.origin,
                    length * (share - shareBefore), light, shareBefore, share);
        shareBefore = share;
        from = to;
    }
}

/// Adds the part of a ray through a cell with the knots of several segments: a slab for each, in the order in which the
/// ray meets them (R22).
template <class Lanes, class Light>
TETRA_SIMD_INLINE void addSlices(Gathered<Lanes>& gathered, const ScaledSegment* segments, const CellSetup& cell,
                                 Lanes valueIn, Lanes valueOut, Lanes length, const Light& light)
{
    const Lanes lowest = Lanes{} + cell.smallest;
    const Lanes highest = Lanes{} + cell.largest;
    valueIn = smaller(larger(valueIn, lowest), highest);
    valueOut = smaller(larger(valueOut, lowest), highest);
    const Lanes rise = valueOut - valueIn;
    // Where the value hardly changes, the whole ray goes to the segment of its start.
    constexpr float levelRise = 1e-8f;
    const bool down = cell.direction == Direction::Falling;
    const Lanes level = Lanes{} + (down ? -levelRise : levelRise);
    const Lanes perRise = 1.0f / (larger(rise, -rise) < levelRise ? level : rise);
    if (cell.direction != Direction::Mixed)
        return addSlicesOneWay(gathered, segments, cell, !down, valueIn, rise, perRise, length, light);
    // Comparisons stand where they choose: compilers do badly when they have to keep 16 of them.
    addSlicesOneWay(gathered, segments, cell, true, valueIn, rise, perRise, perRise < 0.0f ? Lanes{} : length, light);
    const Lanes falling = perRise < 0.0f ? length : Lanes{};
    if (anyPositive(falling))
        addSlicesOneWay(gathered, segments, cell, false, valueIn, rise, perRise, falling, light);
}

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
