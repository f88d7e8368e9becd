// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/facing.h"

#include "core/graphics/volume/cell_geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace tetra {
namespace {

constexpr std::size_t grain = 1 << 12;
constexpr std::size_t lanes = 8;

/// A position that loads at once.
struct alignas(16) PaddedPosition {
    float x, y, z, unused;
};

struct Vectors {
    Double8 x, y, z;
};

TETRA_SIMD_INLINE void loadCorner(const PaddedPosition* positions, const std::array<std::uint32_t, 4>* cells,
                                  std::size_t corner, Vectors& vectors)
{
    Float4 rows[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
        std::memcpy(&rows[lane], &positions[cells[lane][corner]], sizeof rows[lane]);
    Float8 x, y, z, unused;
    transpose(rows, x, y, z, unused);
    vectors.x = __builtin_convertvector(x, Double8);
    vectors.y = __builtin_convertvector(y, Double8);
    vectors.z = __builtin_convertvector(z, Double8);
}

TETRA_SIMD_INLINE void subtract(const Vectors& one, const Vectors& other, Vectors& difference)
{
    difference.x = one.x - other.x;
    difference.y = one.y - other.y;
    difference.z = one.z - other.z;
}

TETRA_SIMD_INLINE void cross(const Vectors& a, const Vectors& b, Vectors& product)
{
    product.x = a.y * b.z - a.z * b.y;
    product.y = a.z * b.x - a.x * b.z;
    product.z = a.x * b.y - a.y * b.x;
}

TETRA_SIMD_INLINE void dot(const Vectors& a, const Vectors& b, Double8& product)
{
    product = a.x * b.x + a.y * b.y + a.z * b.z;
}

/// All but the sign.
TETRA_SIMD_INLINE void magnitude(const Double8& of, Double8& result)
{
    constexpr long mask = 0x7fffffffffffffff;
    result = (Double8)((Long8)of & mask);
}

/// 1 where a value is negative. Comparing vectors that are done in pieces is slow.
TETRA_SIMD_INLINE void signs(const Double8& of, Long8& result)
{
    result = (Long8)of >> 63 & 1;
}

/// What rounding may do to the heights below, many times over.
TETRA_SIMD_INLINE void toleranceOf(const Vectors (&edges)[3], const Vectors& toEye, Double8& tolerance)
{
    constexpr double rounding = 1e-14;
    Double8 part, lengths = {}, distance = {};
    for (const Vectors& edge : edges)
        for (const Double8* component : {&edge.x, &edge.y, &edge.z}) {
            magnitude(*component, part);
            lengths += part;
        }
    for (const Double8* component : {&toEye.x, &toEye.y, &toEye.z}) {
        magnitude(*component, part);
        distance += part;
    }
    tolerance = lengths * lengths * distance * rounding;
}

TETRA_SIMD_INLINE void faceEight(const std::array<std::uint32_t, 4>* cells, const PaddedPosition* positions,
                                 const double* eye, double perspective, std::uint8_t* facing)
{
    Vectors origin, edges[3], toEye, normals[3];
    loadCorner(positions, cells, 0, origin);
    for (std::size_t i = 0; i < 3; ++i) {
        Vectors corner;
        loadCorner(positions, cells, i + 1, corner);
        subtract(corner, origin, edges[i]);
    }
    toEye.x = eye[0] - perspective * origin.x;
    toEye.y = eye[1] - perspective * origin.y;
    toEye.z = eye[2] - perspective * origin.z;
    // Outwards, those of the faces opposite to corners 1, 2, 3; with that opposite to 0 their sum is zero.
    cross(edges[2], edges[1], normals[0]);
    cross(edges[0], edges[2], normals[1]);
    cross(edges[1], edges[0], normals[2]);
    Double8 heights[4], minusVolume, tolerance;
    for (std::size_t i = 0; i < 3; ++i)
        dot(normals[i], toEye, heights[i + 1]);
    dot(normals[0], edges[0], minusVolume);
    heights[0] = perspective * minusVolume - (heights[1] + heights[2] + heights[3]);
    toleranceOf(edges, toEye, tolerance);
    Long8 bits = {};
    for (int face = 0; face < 4; ++face) {
        Long8 outside, inside;
        signs(tolerance - heights[face], outside);
        signs(tolerance + heights[face], inside);
        bits |= outside << face | inside << (4 + face);
    }
    using Byte8 = unsigned char __attribute__((vector_size(8)));
    const Byte8 bytes = __builtin_convertvector(bits, Byte8);
    std::memcpy(facing, &bytes, lanes);
}

/// `count` at least 8 cells.
TETRA_SIMD_CLONES void faceCells(const std::array<std::uint32_t, 4>* cells, std::size_t count,
                                 const PaddedPosition* positions, const double* eye, double perspective,
                                 std::uint8_t* facing)
{
    for (std::size_t first = 0; first < count; first += lanes) {
        const std::size_t start = std::min(first, count - lanes); // the last eight may overlap those before
        faceEight(cells + start, positions, eye, perspective, facing + start);
    }
}

Buffer<PaddedPosition> paddedPositions(const TetrahedralMesh& mesh)
{
    Buffer<PaddedPosition> padded(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, padded.size(), grain), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            padded[v] = {mesh.positions[v].x(), mesh.positions[v].y(), mesh.positions[v].z(), 0};
    });
    return padded;
}

} // namespace

Buffer<std::uint8_t> faceFacing(const TetrahedralMesh& mesh, const EyePoint& eye)
{
    const Buffer<PaddedPosition> positions = paddedPositions(mesh);
    const auto& cells = mesh.tetrahedra;
    const double perspective = eye.perspective ? 1 : 0;
    Buffer<std::uint8_t> facing(cells.size());
    if (cells.size() < lanes) {
        std::array<std::array<std::uint32_t, 4>, lanes> padded{};
        std::array<std::uint8_t, lanes> bits{};
        std::ranges::copy(cells, padded.begin());
        if (!cells.empty())
            faceCells(padded.data(), lanes, positions.data(), eye.place.data(), perspective, bits.data());
        std::copy_n(bits.begin(), facing.size(), facing.begin());
        return facing;
    }
    const std::size_t parts = std::max<std::size_t>(cells.size() / grain, 1);
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        const std::size_t begin = part * grain;
        const std::size_t end = part + 1 == parts ? cells.size() : begin + grain;
        faceCells(&cells[begin], end - begin, positions.data(), eye.place.data(), perspective, &facing[begin]);
    });
    return facing;
}

} // namespace tetra
