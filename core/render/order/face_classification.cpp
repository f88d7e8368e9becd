// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/order/face_classification.h"

#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "core/render/mesh_origin.h"
#include "core/render/order/cell_geometry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace tetra {
namespace {

constexpr std::size_t cellsFacedAtOnce = 1 << 12;
constexpr std::size_t classificationLanes = 8;

/// A position, from the origin of its RoughPositions, that loads at once.
struct alignas(16) PaddedPosition {
    float x, y, z, unused;
};

/// The positions of a mesh, as they are and rounded to floats; those are told from the eye or, where that is infinitely
/// far, from a vertex, so that what rounding does is small beside the distance.
struct RoughPositions {
    const Eigen::Vector3d* exact;
    const PaddedPosition* rough;
    double eye[3];      ///< in the coordinates of `exact`
    double roughEye[3]; ///< in those of `rough`
    double reach;       ///< no rough coordinate is larger, where the eye is infinitely far
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

TETRA_SIMD_INLINE void loadCorner(const Eigen::Vector3d* positions, const std::array<std::uint32_t, 4>* cells,
                                  std::size_t corner, Vectors<Double8>& vectors)
{
    std::array<double, classificationLanes> x, y, z;
    for (std::size_t lane = 0; lane < classificationLanes; ++lane) {
        const double* const place = positions[cells[lane][corner]].data();
        x[lane] = place[0];
        y[lane] = place[1];
        z[lane] = place[2];
    }
    std::memcpy(&vectors.x, x.data(), sizeof vectors.x);
    std::memcpy(&vectors.y, y.data(), sizeof vectors.y);
    std::memcpy(&vectors.z, z.data(), sizeof vectors.z);
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

/// What is known of eight cells: `Bits` gets the facing of each, `rounding` is many times what one operation errs, and
/// `reach` tells how far corners may lie from the origin, beside the eye's distance: they are rounded by such a part
/// of it, or not at all if it is negative.
template <class Lanes, class Bits, class Scalar>
TETRA_SIMD_INLINE void faceEight(const Vectors<Lanes> (&corners)[4], const double* eye, double perspective,
                                 Scalar rounding, Scalar reach, Bits& bits)
{
    const Vectors<Lanes>& origin = corners[0];
    Vectors<Lanes> edges[3], toEye, normals[3];
    Lanes lengths = {}, distance = {};
    for (std::size_t i = 0; i < 3; ++i) {
        subtract(corners[i + 1], origin, edges[i]);
        addMagnitudes(edges[i], lengths);
    }
    const auto scale = static_cast<Scalar>(perspective);
    toEye.x = static_cast<Scalar>(eye[0]) - scale * origin.x;
    toEye.y = static_cast<Scalar>(eye[1]) - scale * origin.y;
    toEye.z = static_cast<Scalar>(eye[2]) - scale * origin.z;
    addMagnitudes(toEye, distance);
    // What the eye's own rounding may do, and that of the volume where the eye is near.
    distance += static_cast<Scalar>(std::abs(eye[0]) + std::abs(eye[1]) + std::abs(eye[2])) + scale * lengths;
    // Outwards, those of the faces opposite to corners 1, 2, 3; with that opposite to 0 their sum is zero.
    crossProduct(edges[2], edges[1], normals[0]);
    crossProduct(edges[0], edges[2], normals[1]);
    crossProduct(edges[1], edges[0], normals[2]);
    Lanes heights[4], minusVolume;
    for (std::size_t i = 0; i < 3; ++i)
        dot(normals[i], toEye, heights[i + 1]);
    dot(normals[0], edges[0], minusVolume);
    heights[0] = scale * minusVolume - (heights[1] + heights[2] + heights[3]);
    Lanes doubted = lengths;
    if (reach >= 0)
        doubted += Scalar(0.5) * (distance + reach); // twice as much as corners that are rounded may do
    const Lanes tolerance = lengths * doubted * distance * rounding + smallestHeight;
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
std::uint8_t exactClass(const std::array<std::uint32_t, 4>& cell, const Eigen::Vector3d* positions,
                        const std::array<double, 3>& from, double perspective, unsigned known)
{
    using Point = std::array<double, 3>;
    for (unsigned face = 0; face < 4; ++face) {
        if ((known >> face & 0x11u) != 0)
            continue;
        std::array<Point, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d& position = positions[cell[cornersOfFace[face][i]]];
            corners[i] = {position.x(), position.y(), position.z()};
        }
        const auto& [a, b, c] = corners;
        const int side = perspective != 0 ? orientationSign(a, b, c, from) : directionSign(a, b, c, from);
        known |= (side > 0 ? 1u : side < 0 ? 16u : 0u) << face;
    }
    return static_cast<std::uint8_t>(known);
}

/// In single precision; where that cannot tell, in double, and then exactly.
TETRA_SIMD_INLINE void faceEight(const std::array<std::uint32_t, 4>* cells, const RoughPositions& positions,
                                 double perspective, std::uint8_t* facing)
{
    Vectors<Float8> rough[4];
    for (std::size_t i = 0; i < 4; ++i)
        loadCorner(positions.rough, cells, i, rough[i]);
    Int8 quick;
    faceEight(rough, positions.roughEye, perspective, 1e-6f, static_cast<float>(positions.reach), quick);
    Byte8 bytes = __builtin_convertvector(quick, Byte8);
    std::uint64_t known = 0;
    std::memcpy(&known, &bytes, classificationLanes);
    std::memcpy(facing, &known, classificationLanes);
    if (allKnown(known))
        return;
    Vectors<Double8> corners[4];
    for (std::size_t i = 0; i < 4; ++i)
        loadCorner(positions.exact, cells, i, corners[i]);
    Long8 sure;
    faceEight(corners, positions.eye, perspective, 1e-14, -1.0, sure);
    bytes = __builtin_convertvector(sure, Byte8);
    std::memcpy(&known, &bytes, classificationLanes);
    std::memcpy(facing, &known, classificationLanes);
    if (!allKnown(known))
        for (std::size_t lane = 0; lane < classificationLanes; ++lane)
            facing[lane] =
                exactClass(cells[lane], positions.exact, {positions.eye[0], positions.eye[1], positions.eye[2]},
                           perspective, facing[lane]);
}

/// `count` at least 8 cells.
TETRA_SIMD_INLINE void faceCells(const std::array<std::uint32_t, 4>* cells, std::size_t count,
                                 const RoughPositions& positions, double perspective, std::uint8_t* facing)
{
    const RoughPositions own = positions; // no byte of it can be one of `facing`
    for (std::size_t first = 0; first < count; first += classificationLanes) {
        const std::size_t start =
            std::min(first, count - classificationLanes); // the last eight may overlap those before
        faceEight(cells + start, own, perspective, facing + start);
    }
}

Buffer<PaddedPosition> paddedPositions(const TetrahedralMesh& mesh, const Eigen::Vector3d& origin)
{
    Buffer<PaddedPosition> padded(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, padded.size(), cellsFacedAtOnce), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            const Eigen::Vector3f place = (mesh.positions[v] - origin).cast<float>();
            padded[v] = {place.x(), place.y(), place.z(), 0};
        }
    });
    return padded;
}

float largestCoordinate(const Buffer<PaddedPosition>& positions)
{
    const auto largestIn = [&](const auto& range, float largest) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            for (const float coordinate : {positions[v].x, positions[v].y, positions[v].z})
                if (isFiniteByBits(coordinate))
                    largest = std::max(largest, std::abs(coordinate));
        return largest;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, positions.size(), cellsFacedAtOnce), 0.0f, largestIn,
                                [](float a, float b) { return std::max(a, b); });
}

} // namespace

Buffer<std::uint8_t> classifyFaces(const TetrahedralMesh& mesh, const EyePoint& eye)
{
    const Eigen::Vector3d zero(0, 0, 0);
    const Eigen::Vector3d origin = eye.perspective ? eye.place : meshOrigin(mesh.positions);
    const Buffer<PaddedPosition> rough = paddedPositions(mesh, origin);
    const Eigen::Vector3d roughEye = eye.perspective ? zero : eye.place;
    const RoughPositions positions{mesh.positions.data(),
                                   rough.data(),
                                   {eye.place.x(), eye.place.y(), eye.place.z()},
                                   {roughEye.x(), roughEye.y(), roughEye.z()},
                                   eye.perspective ? 0 : double(largestCoordinate(rough))};
    const auto& cells = mesh.tetrahedra;
    const double perspective = eye.perspective ? 1 : 0;
    Buffer<std::uint8_t> facing(cells.size());
    if (cells.size() < classificationLanes) {
        std::array<std::array<std::uint32_t, 4>, classificationLanes> padded{};
        std::array<std::uint8_t, classificationLanes> bits{};
        std::ranges::copy(cells, padded.begin());
        if (!cells.empty())
            dispatch<faceCells>(padded.data(), classificationLanes, positions, perspective, bits.data());
        std::copy_n(bits.begin(), facing.size(), facing.begin());
        return facing;
    }
    const std::size_t parts = std::max<std::size_t>(cells.size() / cellsFacedAtOnce, 1);
    tbb::parallel_for(std::size_t(0), parts, [&](std::size_t part) {
        const std::size_t begin = part * cellsFacedAtOnce;
        const std::size_t end = part + 1 == parts ? cells.size() : begin + cellsFacedAtOnce;
        dispatch<faceCells>(&cells[begin], end - begin, positions, perspective, &facing[begin]);
    });
    return facing;
}

} // namespace tetra
