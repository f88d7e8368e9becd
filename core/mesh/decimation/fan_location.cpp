// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/fan_location.h"

#include "core/base/simd.h"

#include <cstring>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

constexpr std::size_t fanLanes = 8;

/// Adds a column's numbers of eight faces, times the factors.
TETRA_SIMD_INLINE void addTaken(const double* column, const std::uint32_t* faces, const Double8& factors, Double8& sum)
{
    sum += factors * Double8{column[faces[0]], column[faces[1]], column[faces[2]], column[faces[3]],
                             column[faces[4]], column[faces[5]], column[faces[6]], column[faces[7]]};
}

/// From which face each of the places gets its tetrahedron, by its place in the list of faces, to its number, and how
/// far the values are from the apex's.
TETRA_SIMD_INLINE void takeOwners(const FanTetrahedra& tetrahedra, const Double8* from, const Double8& owner,
                                  std::uint32_t* owners, double* steps)
{
    for (std::size_t lane = 0; lane < fanLanes; ++lane)
        owners[lane] = tetrahedra.faces[static_cast<std::size_t>(owner[lane])];
    Double8 step{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        addTaken(tetrahedra.columns.data() + (9 + axis) * tetrahedra.columnLength, owners, from[axis], step);
    std::memcpy(steps, &step, sizeof step);
}

TETRA_SIMD_INLINE void placesFromApex(const FanTetrahedra& tetrahedra, const std::array<const double*, 3>& places,
                                      Double8* from)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(&from[axis], places[axis], sizeof from[axis]);
        from[axis] = from[axis] - tetrahedra.apex[axis];
    }
}

/// Goes through all weights of all tetrahedra.
TETRA_SIMD_CLONES void locateThroughout(const FanTetrahedra& tetrahedra, const std::array<const double*, 3>& places,
                                        std::uint32_t* owners, double* steps)
{
    Double8 from[3];
    placesFromApex(tetrahedra, places, from);
    const Double8 x = from[0], y = from[1], z = from[2];
    const std::size_t count = tetrahedra.columnLength;
    Double8 deepest = x * 0 - 1e300;
    Double8 number = x * 0;
    Double8 owner = number;
    for (const std::uint32_t face : tetrahedra.faces) {
        const double* row = tetrahedra.columns.data() + face;
        const Double8 a = row[0] * x + row[count] * y + row[2 * count] * z;
        const Double8 b = row[3 * count] * x + row[4 * count] * y + row[5 * count] * z;
        const Double8 c = row[6 * count] * x + row[7 * count] * y + row[8 * count] * z;
        const Double8 lower = a < b ? a : b;
        const Double8 depth = lower < c ? lower : c;
        owner = depth > deepest ? number : owner;
        deepest = depth > deepest ? depth : deepest;
        number = number + 1;
    }
    takeOwners(tetrahedra, from, owner, owners, steps);
}

#if defined(TETRA_SIMD_16)

/// The weights of one corner of a face's tetrahedron at eight places.
TETRA_SIMD_16 TETRA_SIMD_INLINE Double8 barycentricRow(const double* row, std::size_t count, const Double8* from)
{
    return row[0] * from[0] + row[count] * from[1] + row[2 * count] * from[2];
}

TETRA_SIMD_16 TETRA_SIMD_INLINE bool anyGreater(const Double8& one, const Double8& other)
{
    return _mm512_cmp_pd_mask(reinterpret_cast<const __m512d&>(one), reinterpret_cast<const __m512d&>(other),
                              _CMP_GT_OQ) != 0;
}

/// The same result. Passes over a tetrahedron as soon as a weight says for all places that it is not as deep as
/// `latest`, which they may well lie in.
TETRA_SIMD_16 std::size_t locateBeside(const FanTetrahedra& tetrahedra, std::size_t latest,
                                       const std::array<const double*, 3>& places, std::uint32_t* owners, double* steps)
{
    Double8 from[3];
    placesFromApex(tetrahedra, places, from);
    const std::size_t count = tetrahedra.columnLength;
    const Double8 zero{};
    Double8 deepest = zero + 1e300;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const double* row = tetrahedra.columns.data() + 3 * corner * count + tetrahedra.faces[latest];
        const Double8 weight = barycentricRow(row, count, from);
        deepest = weight < deepest ? weight : deepest;
    }
    // A little less, so that the search meets it again in its turn.
    constexpr double less = 1e-6;
    deepest = deepest - less * ((deepest < zero ? -deepest : deepest) + 1);
    Double8 owner = zero;
    for (std::size_t i = 0; i < tetrahedra.faces.size(); ++i) {
        const double* row = tetrahedra.columns.data() + tetrahedra.faces[i];
        const Double8 a = barycentricRow(row, count, from);
        if (!anyGreater(a, deepest))
            continue;
        const Double8 b = barycentricRow(row + 3 * count, count, from);
        const Double8 lower = a < b ? a : b;
        if (!anyGreater(lower, deepest))
            continue;
        const Double8 c = barycentricRow(row + 6 * count, count, from);
        const Double8 depth = lower < c ? lower : c;
        owner = depth > deepest ? zero + static_cast<double>(i) : owner;
        deepest = depth > deepest ? depth : deepest;
    }
    takeOwners(tetrahedra, from, owner, owners, steps);
    return static_cast<std::size_t>(owner[fanLanes - 1]);
}

#endif

} // namespace

FanLocation::FanLocation(const FanTetrahedra& tetrahedra, std::size_t placeCount)
    : tetrahedra_(tetrahedra), many_(false)
{
#if defined(TETRA_SIMD_16)
    constexpr std::size_t few = 128; // whose branches are not foreseen
    static const bool canPassOver = hasSimd16();
    many_ = canPassOver && placeCount > few;
#else
    static_cast<void>(placeCount);
#endif
}

void FanLocation::locateEight(const std::array<const double*, 3>& places, std::uint32_t* owners, double* steps)
{
#if defined(TETRA_SIMD_16)
    if (many_) {
        latest_ = locateBeside(tetrahedra_, latest_, places, owners, steps);
        return;
    }
#endif
    locateThroughout(tetrahedra_, places, owners, steps);
}

} // namespace tetra
