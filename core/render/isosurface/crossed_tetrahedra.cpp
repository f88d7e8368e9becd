// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/isosurface/crossed_tetrahedra.h"

#include "core/base/simd.h"
#include "core/mesh/topology.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

/// The smallest float that is inside.
float smallestInside(double isovalue)
{
    const auto nearest = static_cast<float>(isovalue);
    return static_cast<double>(nearest) >= isovalue ? nearest
                                                    : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

TETRA_SIMD_INLINE void classify(const float* values, std::size_t count, float threshold, std::uint8_t* inside)
{
    for (std::size_t v = 0; v < count; ++v)
        inside[v] = values[v] >= threshold ? 1 : 0;
}

/// Written always and kept only if crossed: cheaper than a branch that is hard to predict.
CrossedTetrahedron* findOneByOne(std::span<const Tetrahedron> tetrahedra, std::size_t first, const std::uint8_t* inside,
                                 CrossedTetrahedron* found)
{
    constexpr unsigned crossing = 0b0111111111111110;
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
        const auto& [a, b, c, d] = tetrahedra[i];
        const unsigned bits = static_cast<unsigned>(inside[a] | inside[b] << 1 | inside[c] << 2 | inside[d] << 3);
        *found = static_cast<CrossedTetrahedron>((first + i) << 4 | bits);
        found += crossing >> bits & 1;
    }
    return found;
}

#if defined(TETRA_SIMD_16)

constexpr std::size_t cellsScannedAtOnce = 16;

/// Four bits a tetrahedron, corner by corner as they lie in memory: four gathers of sixteen corners each need no
/// transposition.
TETRA_SIMD_INLINE TETRA_SIMD_16 std::uint64_t sidesOfCorners(const Tetrahedron* tetrahedra, const std::uint8_t* inside)
{
    const __m512i one = _mm512_set1_epi32(1);
    std::uint64_t bits = 0;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const __m512i corners = _mm512_loadu_si512(tetrahedra + 4 * quarter);
        const __m512i sides = _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xffff, corners, inside, 1);
        bits |= std::uint64_t(_mm512_test_epi32_mask(sides, one)) << (16 * quarter);
    }
    return bits;
}

/// A whole number of sixteens.
TETRA_SIMD_16 CrossedTetrahedron* findSixteenAtOnce(std::span<const Tetrahedron> tetrahedra, std::size_t first,
                                                    const std::uint8_t* inside, CrossedTetrahedron* found)
{
    constexpr std::uint64_t firstCorners = 0x1111111111111111;
    constexpr Int16 lanes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    for (std::size_t i = 0; i < tetrahedra.size(); i += cellsScannedAtOnce) {
        const std::uint64_t bits = sidesOfCorners(tetrahedra.data() + i, inside);
        const std::uint64_t differ = bits ^ bits >> 1; // of one corner and the next one
        const std::uint64_t crossed = (differ | differ >> 1 | differ >> 2) & firstCorners;
        const auto both = reinterpret_cast<Int16>(
            _mm512_mask_set1_epi32(_mm512_set1_epi32(static_cast<int>(bits)), 0xff00, static_cast<int>(bits >> 32)));
        const Int16 cases = both >> (4 * lanes & 31) & 15;
        const Int16 numbers = static_cast<int>(first + i) + lanes;
        const auto kept = static_cast<__mmask16>(_pext_u64(crossed, firstCorners));
        _mm512_storeu_si512(found, _mm512_maskz_compress_epi32(kept, reinterpret_cast<__m512i>(numbers << 4 | cases)));
        found += std::popcount(crossed);
    }
    return found;
}

#endif

} // namespace

VertexSigns::VertexSigns(std::span<const float> values, double isovalue) : bytes_(values.size() + padding)
{
    const float threshold = smallestInside(isovalue);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), 1 << 15), [&](const auto& range) {
        dispatch<classify>(&values[range.begin()], range.size(), threshold, &bytes_[range.begin()]);
    });
    std::fill_n(bytes_.end() - padding, padding, std::uint8_t(0));
}

CrossedTetrahedron* findCrossed(std::span<const Tetrahedron> tetrahedra, std::size_t first, const VertexSigns& sides,
                                CrossedTetrahedron* found)
{
#if defined(TETRA_SIMD_16)
    constexpr auto mostVertices =
        static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()); // gathers' numbers
    if (simdLevel() == SimdLevel::Sixteen && sides.size() <= mostVertices) {
        const std::size_t count = tetrahedra.size() / cellsScannedAtOnce * cellsScannedAtOnce;
        found = findSixteenAtOnce(tetrahedra.first(count), first, sides.bytes(), found);
        tetrahedra = tetrahedra.subspan(count);
        first += count;
    }
#endif
    return findOneByOne(tetrahedra, first, sides.bytes(), found);
}

namespace {

EdgeKey* writeOneByOne(std::span<const Tetrahedron> tetrahedra, std::span<const CrossedTetrahedron> crossed,
                       EdgeKey* edges)
{
    for (const CrossedTetrahedron one : crossed) {
        const Tetrahedron& tetrahedron = tetrahedra[one / 16];
        const MarchingCase& marching = marchingCases[one % 16];
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto [a, b] = marching.edges[corner];
            edges[corner] = edgeKey(tetrahedron[a], tetrahedron[b]);
        }
        edges += marching.corners;
    }
    return edges;
}

#if defined(TETRA_SIMD_16)

/// One end of each edge of a marching case, and the other one.
struct EdgeEnds {
    alignas(16) std::array<std::array<std::int32_t, 4>, 2> corners;
};

constexpr std::array<EdgeEnds, 16> edgeEnds = [] {
    std::array<EdgeEnds, 16> all{};
    for (std::size_t inside = 0; inside < all.size(); ++inside)
        for (std::size_t edge = 0; edge < 4; ++edge)
            for (std::size_t end = 0; end < 2; ++end)
                all[inside].corners[end][edge] = marchingCases[inside].edges[edge][end];
    return all;
}();

TETRA_SIMD_INLINE TETRA_SIMD_8 __m128i cornersOf(__m128i tetrahedron, const std::array<std::int32_t, 4>& which)
{
    const __m128i places = _mm_load_si128(reinterpret_cast<const __m128i*>(which.data()));
    return _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(tetrahedron), places));
}

/// The same with the four edges of a tetrahedron side by side.
TETRA_SIMD_8 EdgeKey* writeFourAtOnce(std::span<const Tetrahedron> tetrahedra,
                                      std::span<const CrossedTetrahedron> crossed, EdgeKey* edges)
{
    for (const CrossedTetrahedron one : crossed) {
        const __m128i tetrahedron = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&tetrahedra[one / 16]));
        const EdgeEnds& ends = edgeEnds[one % 16];
        const __m128i a = cornersOf(tetrahedron, ends.corners[0]);
        const __m128i b = cornersOf(tetrahedron, ends.corners[1]);
        const __m128i smaller = _mm_min_epu32(a, b), larger = _mm_max_epu32(a, b);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(edges), _mm_unpacklo_epi32(larger, smaller));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(edges + 2), _mm_unpackhi_epi32(larger, smaller));
        edges += marchingCases[one % 16].corners;
    }
    return edges;
}

#endif

} // namespace

EdgeKey* writeCrossedEdges(std::span<const Tetrahedron> tetrahedra, std::span<const CrossedTetrahedron> crossed,
                           EdgeKey* edges)
{
#if defined(TETRA_SIMD_8)
    if (simdLevel() >= SimdLevel::Eight)
        return writeFourAtOnce(tetrahedra, crossed, edges);
#endif
    return writeOneByOne(tetrahedra, crossed, edges);
}

} // namespace tetra
