// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/crossed_edges.h"

#include "core/base/simd.h"
#include "core/graphics/marching_cases.h"

#include <algorithm>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {
namespace {

using CrossedCorners = std::array<std::uint32_t, 4>;

EdgeKey* writeOneByOne(std::span<const CrossedCorners> tetrahedra, std::span<const CrossedTetrahedron> crossed,
                       EdgeKey* edges)
{
    for (const CrossedTetrahedron one : crossed) {
        const CrossedCorners& tetrahedron = tetrahedra[one / 16];
        const MarchingCase& marching = marchingCases[one % 16];
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const EdgeKey a = tetrahedron[marching.edges[corner][0]];
            const EdgeKey b = tetrahedron[marching.edges[corner][1]];
            edges[corner] = std::min(a << 32 | b, b << 32 | a); // compilers make no branch of this
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

TETRA_SIMD_8 TETRA_SIMD_INLINE __m128i cornersOf(__m128i tetrahedron, const std::array<std::int32_t, 4>& which)
{
    const __m128i places = _mm_load_si128(reinterpret_cast<const __m128i*>(which.data()));
    return _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(tetrahedron), places));
}

/// The same with the four edges of a tetrahedron side by side.
TETRA_SIMD_8 EdgeKey* writeFourAtOnce(std::span<const CrossedCorners> tetrahedra,
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

EdgeKey* writeCrossedEdges(std::span<const CrossedCorners> tetrahedra, std::span<const CrossedTetrahedron> crossed,
                           EdgeKey* edges)
{
#if defined(TETRA_SIMD_16)
    static const bool fourAtOnce = hasSimd8();
    if (fourAtOnce)
        return writeFourAtOnce(tetrahedra, crossed, edges);
#endif
    return writeOneByOne(tetrahedra, crossed, edges);
}

} // namespace tetra
