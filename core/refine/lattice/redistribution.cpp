// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/redistribution.h"

#include "core/base/simd.h"
#include "core/refine/lattice/star.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace tetra {

namespace {

/// Points in the tetrahedra of a star. All arrays are equally long, a multiple of four.
struct OwnedPoints {
    std::span<const PackedPoint> points;
    std::span<const std::int32_t> owners; ///< the star's tetrahedron that has the point
    std::span<const float> x, y, z;       ///< relative to the apex
};

/// One tetrahedron of the star with the values of its vertices.
struct ValuedFace {
    const Star::Face& geometry;
    std::array<PackedPoint, 4> vertices; ///< apex, a, b, c
    std::array<double, 4> values;
};

/// The error of a point at (x, y, z) from the apex, which depends only on the vertices of non-zero weight and on the
/// weights as reduced fractions, summed in the lattice's order: on a face of the tetrahedron, not on its fourth vertex.
double independentError(const ValuedFace& face, double value, double x, double y, double z)
{
    const auto weight = [&](std::size_t first) {
        const auto& normals = face.geometry.normals;
        return static_cast<std::int64_t>(normals[first] * x + normals[first + 1] * y + normals[first + 2] * z);
    };
    const auto determinant = static_cast<std::int64_t>(face.geometry.determinant());
    std::array<std::int64_t, 4> weights{0, weight(0), weight(4), weight(8)};
    weights[0] = determinant - weights[1] - weights[2] - weights[3];
    std::int64_t divisor = determinant;
    for (const std::int64_t one : weights)
        divisor = std::gcd(divisor, one);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::ranges::sort(order, {}, [&](std::size_t i) { return face.vertices[i]; });
    double sum = 0;
    for (const std::size_t i : order)
        if (weights[i] != 0)
            sum += static_cast<double>(weights[i] / divisor) * (value - face.values[i]);
    return std::abs(sum) / static_cast<double>(determinant / divisor);
}

/// The field of each tetrahedron as a plane: its slopes times the determinant, then the determinant; all exact integers
/// for integer samples of up to 16 bits.
TETRA_SIMD_INLINE void computeFieldPlanes(std::span<const Star::Face> faces,
                                          const std::array<std::uint32_t, 3>* corners, double apexValue,
                                          const double* rimValues, std::array<double, 4>* planes)
{
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Star::Face& face = faces[i];
        Double4 normalBC, normalCA, normalAB;
        std::memcpy(&normalBC, &face.normals[0], sizeof normalBC);
        std::memcpy(&normalCA, &face.normals[4], sizeof normalCA);
        std::memcpy(&normalAB, &face.normals[8], sizeof normalAB);
        Double4 plane = (rimValues[corners[i][0]] - apexValue) * normalBC +
                        (rimValues[corners[i][1]] - apexValue) * normalCA +
                        (rimValues[corners[i][2]] - apexValue) * normalAB;
        plane[3] = face.determinant();
        std::memcpy(&planes[i], &plane, sizeof plane);
    }
}

/// |value - interpolation|, four points at a time.
TETRA_SIMD_INLINE void computeDistances(const OwnedPoints& owned, const std::array<double, 4>* planes, double apexValue,
                                        const double* values, double* errors)
{
    const auto load = [](Double4& to, const std::span<const float> from, std::size_t i) {
        Float4 numbers;
        std::memcpy(&numbers, from.data() + i, sizeof numbers);
        to = __builtin_convertvector(numbers, Double4);
    };
    const std::int32_t* const owners = owned.owners.data();
    const std::size_t count = owned.points.size();
    for (std::size_t i = 0; i < count; i += 4) {
        Double4 rows[4];
        for (std::size_t k = 0; k < 4; ++k)
            std::memcpy(&rows[k], &planes[owners[i + k]], sizeof rows[k]);
        const Double4 low01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
        const Double4 high01 = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
        const Double4 low23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
        const Double4 high23 = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
        const Double4 slopeX = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
        const Double4 slopeY = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
        const Double4 slopeZ = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
        const Double4 determinant = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
        Double4 value, x, y, z;
        std::memcpy(&value, values + i, sizeof value);
        load(x, owned.x, i);
        load(y, owned.y, i);
        load(z, owned.z, i);
        const Double4 numerator = determinant * (value - apexValue) - slopeX * x - slopeY * y - slopeZ * z;
        const Double4 distance = (numerator < 0.0 ? -numerator : numerator) / determinant;
        std::memcpy(errors + i, &distance, sizeof distance);
    }
}

bool onBoundary(const PackedLattice& lattice, PackedPoint point)
{
    const auto& size = lattice.size();
    const auto outermost = [](std::int32_t coordinate, std::uint32_t count) {
        return coordinate == 0 || static_cast<std::uint32_t>(coordinate) == count - 1;
    };
    return outermost(lattice.x(point), size[0]) || outermost(lattice.y(point), size[1]) ||
           outermost(lattice.z(point), size[2]);
}

/// Makes the errors of the points on the box's boundary independent of the tetrahedron.
void computeBoundaryErrors(const PackedLattice& lattice, const Star& star, const OwnedPoints& owned, double apexValue,
                           const PointErrorScratch& scratch, std::span<double> errors)
{
    const std::span<const PackedPoint> link = star.link();
    for (std::size_t k = 0; k < owned.points.size(); ++k) {
        if (!onBoundary(lattice, owned.points[k]))
            continue;
        const auto owner = static_cast<std::size_t>(owned.owners[k]);
        const auto& [a, b, c] = star.corners()[owner];
        const ValuedFace face{star.faces()[owner],
                              {star.apex(), link[a], link[b], link[c]},
                              {apexValue, scratch.rimValues[a], scratch.rimValues[b], scratch.rimValues[c]}};
        errors[k] = independentError(face, scratch.values[k], owned.x[k], owned.y[k], owned.z[k]);
    }
}

/// errors[i] = the weighted distance of the sample of point i from the interpolation in the tetrahedron that has it. It
/// does not depend, bit for bit, on which of several tetrahedra that hold a point has it, if the point is on the box's
/// boundary: so boxes agree about shared points (S3). For samples of up to 16 bits that is so for all points, because
/// it is one division of exact integers (S8).
void computeErrors(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                   const OwnedPoints& owned, PointErrorScratch& scratch, std::span<double> errors)
{
    const PackedPoint apex = star.apex();
    double apexValue = 0;
    samples.gather(lattice, {&apex, 1}, &apexValue);
    scratch.rimValues.resize(star.link().size());
    samples.gather(lattice, star.link(), scratch.rimValues.data());
    scratch.values.resize(owned.points.size());
    samples.gather(lattice, owned.points, scratch.values.data());
    scratch.planes.resize(star.faceCount());
    dispatch<computeFieldPlanes>(star.faces(), star.corners().data(), apexValue, scratch.rimValues.data(),
                                 scratch.planes.data());
    dispatch<computeDistances>(owned, scratch.planes.data(), apexValue, scratch.values.data(), errors.data());
    if (!samples.exact())
        computeBoundaryErrors(lattice, star, owned, apexValue, scratch, errors);
    if (samples.weighted())
        for (std::size_t k = 0; k < owned.points.size(); ++k)
            errors[k] *= samples.weight(lattice, owned.points[k]);
}

/// Point arrays are padded to what the search tests at a time.
constexpr std::size_t redistributionLanes = coneSearchLanes;

/// Coordinates relative to the apex, eight points at a time.
TETRA_SIMD_INLINE void unpackPoints(const PackedLattice& lattice, PackedPoint apex, const PackedPoint* points,
                                    std::size_t count, float* x, float* y, float* z)
{
    const std::int32_t apexX = lattice.x(apex), apexY = lattice.y(apex), apexZ = lattice.z(apex);
    const PackedLattice local = lattice;
    for (std::size_t i = 0; i < count; i += redistributionLanes) {
        Int8 packed, pointX, pointY, pointZ;
        std::memcpy(&packed, points + i, sizeof packed);
        local.unpack(packed, pointX, pointY, pointZ);
        const Float8 relativeX = __builtin_convertvector(pointX - apexX, Float8);
        const Float8 relativeY = __builtin_convertvector(pointY - apexY, Float8);
        const Float8 relativeZ = __builtin_convertvector(pointZ - apexZ, Float8);
        std::memcpy(x + i, &relativeX, sizeof relativeX);
        std::memcpy(y + i, &relativeY, sizeof relativeY);
        std::memcpy(z + i, &relativeZ, sizeof relativeZ);
    }
}

/// The bits of each error, rounded up to a float, then the complement of the point.
TETRA_SIMD_INLINE void makeKeys(const double* errors, const PackedPoint* points, std::size_t count, std::uint64_t* keys)
{
    for (std::size_t i = 0; i < count; ++i) {
        const float rounded = static_cast<float>(errors[i]);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &rounded, sizeof bits);
        bits += static_cast<double>(rounded) < errors[i];
        keys[i] = std::uint64_t(bits) << 32 | static_cast<std::uint32_t>(~points[i]);
    }
}

} // namespace

TETRA_SIMD_INLINE void Redistribution::findWorst(std::size_t faceCount)
{
    makeKeys(errors_.data(), points_.data(), points_.size(), keys_.data());
    FacePoints* const faces = faces_.data();
    std::fill_n(faces, faceCount, FacePoints{0, 0});
    for (std::size_t i = 0; i < points_.size(); ++i) {
        FacePoints& face = faces[owners_[i]];
        face.worst = std::max(face.worst, keys_[i]);
        ++face.count;
    }
}

void Redistribution::run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                         std::span<const PackedPoint> points)
{
    // The first insertions move millions of points, the later ones dozens: give the room of the first back.
    constexpr std::size_t roomWorthKeeping = 65536;
    if (points_.capacity() > std::max(roomWorthKeeping, 16 * points.size()))
        *this = Redistribution();
    // The padding repeats the apex, which every tetrahedron has.
    const std::size_t padded = (points.size() + redistributionLanes - 1) / redistributionLanes * redistributionLanes;
    points_.resize(padded);
    std::ranges::copy(points, points_.begin());
    std::fill(points_.begin() + static_cast<std::ptrdiff_t>(points.size()), points_.end(), star.apex());
    for (Buffer<float>* coordinates : {&x_, &y_, &z_})
        coordinates->resize(padded);
    owners_.resize(padded);
    errors_.resize(padded);
    dispatch<unpackPoints>(lattice, star.apex(), points_.data(), padded, x_.data(), y_.data(), z_.data());
    locateInStar(star, {x_, y_, z_}, planes_, owners_);
    computeErrors(lattice, samples, star, {points_, owners_, x_, y_, z_}, scratch_, errors_);
    points_.resize(points.size());
    keys_.resize(points.size());
    faces_.resize(star.faceCount());
    dispatch<&Redistribution::findWorst>(*this, star.faceCount());
}

} // namespace tetra
