// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace tetra {

/// A vertex in the picture: its image (VolumeView) and its scaled value (ScaledSegments).
struct alignas(16) ProjectedVertex {
    float u, v, w, value;
};

/// The field's gradient at a vertex for light, in any unit: right, down, and away from the eye.
struct alignas(16) VertexGradient {
    float right, down, away, unused;
};

/// The corners of eight cells, a lane each.
struct CellCorners {
    Float8 u[4], v[4], w[4], value[4];
};

/// The planes of eight cells' faces: the inside of face f is normal . (u, v, w) >= offset. Normals are as long as twice
/// the face's area, and volume is six times the cell's. All signs are those of positive cells.
struct CellPlanes {
    Float8 u[4], v[4], w[4], offset[4];
    Float8 volume;
};

/// For use inside functions compiled for several instruction sets.
TETRA_SIMD_INLINE void transpose(const Float4 (&rows)[8], Float8& a, Float8& b, Float8& c, Float8& d)
{
    Float8 pairs[4];
    for (int i = 0; i < 4; ++i)
        pairs[i] = __builtin_shufflevector(rows[i], rows[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    const Float8 ab01 = __builtin_shufflevector(pairs[0], pairs[1], 0, 8, 1, 9, 4, 12, 5, 13);
    const Float8 cd01 = __builtin_shufflevector(pairs[0], pairs[1], 2, 10, 3, 11, 6, 14, 7, 15);
    const Float8 ab23 = __builtin_shufflevector(pairs[2], pairs[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const Float8 cd23 = __builtin_shufflevector(pairs[2], pairs[3], 2, 10, 3, 11, 6, 14, 7, 15);
    a = __builtin_shufflevector(ab01, ab23, 0, 1, 8, 9, 4, 5, 12, 13);
    b = __builtin_shufflevector(ab01, ab23, 2, 3, 10, 11, 6, 7, 14, 15);
    c = __builtin_shufflevector(cd01, cd23, 0, 1, 8, 9, 4, 5, 12, 13);
    d = __builtin_shufflevector(cd01, cd23, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// The inverse: row i gets lane i of each.
TETRA_SIMD_INLINE void transposeBack(Float8 a, Float8 b, Float8 c, Float8 d, Float4 (&rows)[8])
{
    const Float8 abLow = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Float8 abHigh = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Float8 cdLow = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Float8 cdHigh = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    const Float8 pairs[4] = {__builtin_shufflevector(abLow, cdLow, 0, 1, 8, 9, 4, 5, 12, 13),
                             __builtin_shufflevector(abLow, cdLow, 2, 3, 10, 11, 6, 7, 14, 15),
                             __builtin_shufflevector(abHigh, cdHigh, 0, 1, 8, 9, 4, 5, 12, 13),
                             __builtin_shufflevector(abHigh, cdHigh, 2, 3, 10, 11, 6, 7, 14, 15)};
    for (int i = 0; i < 4; ++i) {
        rows[i] = __builtin_shufflevector(pairs[i], pairs[i], 0, 1, 2, 3);
        rows[i + 4] = __builtin_shufflevector(pairs[i], pairs[i], 4, 5, 6, 7);
    }
}

/// What one corner of eight cells has, four numbers a vertex: lane i gets those of cells[i].
template <class Vertex>
TETRA_SIMD_INLINE void loadCorner(const Vertex* vertices, const std::array<std::uint32_t, 4>* const (&cells)[8],
                                  std::size_t corner, Float8& a, Float8& b, Float8& c, Float8& d)
{
    Float4 rows[8];
    static_assert(sizeof(Vertex) == sizeof(Float4));
    for (std::size_t lane = 0; lane < 8; ++lane)
        std::memcpy(&rows[lane], &vertices[(*cells[lane])[corner]], sizeof rows[lane]);
    transpose(rows, a, b, c, d);
}

/// Lane i gets the corners of cells[i].
TETRA_SIMD_INLINE void loadCorners(const ProjectedVertex* vertices,
                                   const std::array<std::uint32_t, 4>* const (&cells)[8], CellCorners& corners)
{
    for (std::size_t corner = 0; corner < 4; ++corner)
        loadCorner(vertices, cells, corner, corners.u[corner], corners.v[corner], corners.w[corner],
                   corners.value[corner]);
}

TETRA_SIMD_INLINE void makePlanes(const CellCorners& c, CellPlanes& planes)
{
    Float8 eu[4], ev[4], ew[4]; // edges from corner 0
    for (int i = 1; i < 4; ++i) {
        eu[i] = c.u[i] - c.u[0];
        ev[i] = c.v[i] - c.v[0];
        ew[i] = c.w[i] - c.w[0];
    }
    for (int face = 1; face < 4; ++face) {
        const int i = face % 3 + 1, j = (face + 1) % 3 + 1;
        planes.u[face] = ev[i] * ew[j] - ew[i] * ev[j];
        planes.v[face] = ew[i] * eu[j] - eu[i] * ew[j];
        planes.w[face] = eu[i] * ev[j] - ev[i] * eu[j];
        planes.offset[face] = planes.u[face] * c.u[0] + planes.v[face] * c.v[0] + planes.w[face] * c.w[0];
    }
    planes.u[0] = -(planes.u[1] + planes.u[2] + planes.u[3]);
    planes.v[0] = -(planes.v[1] + planes.v[2] + planes.v[3]);
    planes.w[0] = -(planes.w[1] + planes.w[2] + planes.w[3]);
    planes.offset[0] = planes.u[0] * c.u[1] + planes.v[0] * c.v[1] + planes.w[0] * c.w[1];
    planes.volume = planes.u[1] * eu[1] + planes.v[1] * ev[1] + planes.w[1] * ew[1];
}

} // namespace tetra
