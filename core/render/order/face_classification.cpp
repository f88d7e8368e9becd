// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/order/face_classification.h"

#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "core/render/order/cell_geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace tetra {
namespace {

constexpr std::size_t cellsFacedAtOnce = 1 << 12;
constexpr std::size_t classificationLanes = 8;

/// A position that loads at once.
struct alignas(16) PaddedPosition {
    float x, y, z, unused;
};

/// Eight vectors, in single or double precision.
template <class Lanes> struct Vectors {
    Lanes x, y, z;
};

TETRA_SIMD_INLINE void loadCorner(const PaddedPosition* positions, const std::array<std::uint32_t, 4>* cells,
                                  std::size_t corner, Vectors<Float8>& vectors)
{
    Float4 rows[classificationLanes];
    for (std::size_t lane = 0; lane < classificationLanes; ++lane)
        std::memcpy(&rows[lane], &positions[cells[lane][corner]], sizeof rows[lane]);
    Float8 unused;
    transpose(rows, vectors.x, vectors.y, vectors.z, unused);
}

TETRA_SIMD_INLINE void convert(const Vectors<Float8>& from, Vectors<Float8>& to)
{
    to = from;
}

TETRA_SIMD_INLINE void convert(const Vectors<Float8>& from, Vectors<Double8>& to)
{
    to.x = __builtin_convertvector(from.x, Double8);
    to.y = __builtin_convertvector(from.y, Double8);
    to.z = __builtin_convertvector(from.z, Double8);
}

template <class Lanes>
TETRA_SIMD_INLINE void subtract(const Vectors<Lanes>& one, const Vectors<Lanes>& other, Vectors<Lanes>& difference)
{
    difference.x = one.x - other.x;
    difference.y = one.y - other.y;
    difference.z = one.z - other.z;
}

template <class Lanes>
TETRA_SIMD_INLINE void crossProduct(const Vectors<Lanes>& a, const Vectors<Lanes>& b, Vectors<Lanes>& product)
{
    product.x = a.y * b.z - a.z * b.y;
    product.y = a.z * b.x - a.x * b.z;
    product.z = a.x * b.y - a.y * b.x;
}

template <class Lanes> TETRA_SIMD_INLINE void dot(const Vectors<Lanes>& a, const Vectors<Lanes>& b, Lanes& product)
{
    product = a.x * b.x + a.y * b.y + a.z * b.z;
}

/// All but the sign.
TETRA_SIMD_INLINE void magnitude(const Float8& of, Float8& result)
{
    result = (Float8)((Int8)of & 0x7fffffff);
}

TETRA_SIMD_INLINE void magnitude(const Double8& of, Double8& result)
{
    result = (Double8)((Long8)of & 0x7fffffffffffffff);
}

/// `bit` where a value is negative. Comparing vectors that are done in pieces is slow.
TETRA_SIMD_INLINE void signs(const Float8& of, int bit, Int8& result)
{
    result = (Int8)of >> 31 & bit;
}

TETRA_SIMD_INLINE void signs(const Double8& of, int bit, Long8& result)
{
    result = (Long8)of >> 63 & std::int64_t(bit);
}

template <class Lanes> TETRA_SIMD_INLINE void addMagnitudes(const Vectors<Lanes>& of, Lanes& sum)
{
    Lanes part;
    magnitude(of.x, part);
    sum += part;
    magnitude(of.y, part);
    sum += part;
    magnitude(of.z, part);
    sum += part;
}

/// Below it single precision loses digits to underflow.
constexpr float smallestHeight = 1e-36f;

/// What is known of eight cells: `Bits` gets the facing of each, `rounding` many times what one operation errs.
template <class Lanes, class Bits, class Scalar> TETRA_SIMD_INLINE void
faceEight(const Vectors<Float8> (&corners)[4], const double* eye, double perspective, Scalar rounding, Bits& bits)
{
    Vectors<Lanes> origin, edges[3], toEye, normals[3];
    convert(corners[0], origin);
    Lanes lengths = {}, distance = {};
    for (std::size_t i = 0; i < 3; ++i) {
        Vectors<Lanes> corner;
        convert(corners[i + 1], corner);
        subtract(corner, origin, edges[i]);
        addMagnitudes(edges[i], lengths);
    }
    const auto scale = static_cast<Scalar>(perspective);
    toEye.x = static_cast<Scalar>(eye[0]) - scale * origin.x;
    toEye.y = static_cast<Scalar>(eye[1]) - scale * origin.y;
    toEye.z = static_cast<Scalar>(eye[2]) - scale * origin.z;
    addMagnitudes(toEye, distance);
    // What the eye's own rounding may do, and that of the volume where the eye is near.
    distance += static_cast<Scalar>(std::abs(eye[0]) + std::abs(eye[1]) + std::abs(eye[2])) + lengths;
    // Outwards, those of the faces opposite to corners 1, 2, 3; with that opposite to 0 their sum is zero.
    crossProduct(edges[2], edges[1], normals[0]);
    crossProduct(edges[0], edges[2], normals[1]);
    crossProduct(edges[1], edges[0], normals[2]);
    Lanes heights[4], minusVolume;
    for (std::size_t i = 0; i < 3; ++i)
        dot(normals[i], toEye, heights[i + 1]);
    dot(normals[0], edges[0], minusVolume);
    heights[0] = scale * minusVolume - (heights[1] + heights[2] + heights[3]);
    const Lanes tolerance = lengths * lengths * distance * rounding + smallestHeight;
    bits = Bits{};
    for (int face = 0; face < 4; ++face) {
        Bits outside, inside;
        signs(tolerance - heights[face], 1 << face, outside);
        signs(tolerance + heights[face], 16 << face, inside);
        bits |= outside | inside;
    }
}

using Byte8 = unsigned char __attribute__((vector_size(8)));

/// Whether the side of each face of eight cells is known; both bits are set where there was no number.
bool allKnown(std::uint64_t facing)
{
    constexpr std::uint64_t allFaces = 0x0f0f0f0f0f0f0f0f;
    return ((facing ^ facing >> 4) & allFaces) == allFaces;
}

/// The facing of a cell, some faces of which are not known yet.
std::uint8_t exactClass(const std::array<std::uint32_t, 4>& cell, const PaddedPosition* positions,
                        const std::array<double, 3>& from, double perspective, unsigned known)
{
    using Point = std::array<double, 3>;
    for (unsigned face = 0; face < 4; ++face) {
        if ((known >> face & 0x11u) != 0)
            continue;
        std::array<Point, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const PaddedPosition& position = positions[cell[cornersOfFace[face][i]]];
            corners[i] = {position.x, position.y, position.z};
        }
        const auto& [a, b, c] = corners;
        const int side = perspective != 0 ? orientationSign(a, b, c, from) : directionSign(a, b, c, from);
        known |= (side > 0 ? 1u : side < 0 ? 16u : 0u) << face;
    }
    return static_cast<std::uint8_t>(known);
}

/// In single precision; where that cannot tell, in double, and then exactly.
TETRA_SIMD_INLINE void faceEight(const std::array<std::uint32_t, 4>* cells, const PaddedPosition* positions,
                                 const double* eye, double perspective, std::uint8_t* facing)
{
    Vectors<Float8> corners[4];
    for (std::size_t i = 0; i < 4; ++i)
        loadCorner(positions, cells, i, corners[i]);
    Int8 quick;
    faceEight<Float8>(corners, eye, perspective, 1e-6f, quick);
    Byte8 bytes = __builtin_convertvector(quick, Byte8);
    std::uint64_t known = 0;
    std::memcpy(&known, &bytes, classificationLanes);
    std::memcpy(facing, &known, classificationLanes);
    if (allKnown(known))
        return;
    Long8 sure;
    faceEight<Double8>(corners, eye, perspective, 1e-14, sure);
    bytes = __builtin_convertvector(sure, Byte8);
    std::memcpy(&known, &bytes, classificationLanes);
    std::memcpy(facing, &known, classificationLanes);
    if (!allKnown(known))
        for (std::size_t lane = 0; lane < classificationLanes; ++lane)
            facing[lane] = exactClass(cells[lane], positions, {eye[0], eye[1], eye[2]}, perspective, facing[lane]);
}

/// `count` at least 8 cells.
TETRA_SIMD_INLINE void faceCells(const std::array<std::uint32_t, 4>* cells, std::size_t count,
                                 const PaddedPosition* positions, const double* eye, double perspective,
                                 std::uint8_t* facing)
{
    const double from[3] = {eye[0], eye[1], eye[2]}; // no byte of it can be one of `facing`
    for (std::size_t first = 0; first < count; first += classificationLanes) {
        const std::size_t start =
            std::min(first, count - classificationLanes); // the last eight may overlap those before
        faceEight(cells + start, positions, from, perspective, facing + start);
    }
}

Buffer<PaddedPosition> paddedPositions(const TetrahedralMesh& mesh)
{
    Buffer<PaddedPosition> padded(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, padded.size(), cellsFacedAtOnce), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            padded[v] = {mesh.positions[v].x(), mesh.positions[v].y(), mesh.positions[v].z(), 0};
    });
    return padded;
}

} // namespace

Buffer<std::uint8_t> classifyFaces(const TetrahedralMesh& mesh, const EyePoint& eye)
{
    const Buffer<PaddedPosition> positions = paddedPositions(mesh);
    const auto& cells = mesh.tetrahedra;
    const double perspective = eye.perspective ? 1 : 0;
    Buffer<std::uint8_t> facing(cells.size());
    if (cells.size() < classificationLanes) {
        std::array<std::array<std::uint32_t, 4>, classificationLanes> padded{};
        std::array<std::uint8_t, classificationLanes> bits{};
        std::ranges::copy(cells, padded.begin());
        if (!cells.empty())
            dispatch<faceCells>(padded.data(), classificationLanes, positions.data(), eye.place.data(), perspective,
                                bits.data());
        std::copy_n(bits.begin(), facing.size(), facing.begin());
        return facing;
    }
    const std::size_t parts = std::max<std::size_t>(cells.size() / cellsFacedAtOnce, 1);
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        const std::size_t begin = part * cellsFacedAtOnce;
        const std::size_t end = part + 1 == parts ? cells.size() : begin + cellsFacedAtOnce;
        dispatch<faceCells>(&cells[begin], end - begin, positions.data(), eye.place.data(), perspective,
                            &facing[begin]);
    });
    return facing;
}

} // namespace tetra
