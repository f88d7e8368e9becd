// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/relocation.h"

#include "core/base/simd.h"
#include "core/mesh/cone_search.h"

#include <algorithm>
#include <cstring>

namespace tetra {

namespace {

/// Point arrays are padded to what the search tests at a time.
constexpr std::size_t relocationLanes = coneSearchLanes;

/// Coordinates relative to the apex, eight points at a time.
TETRA_SIMD_CLONES void unpackPoints(const PackedLattice& lattice, PackedPoint apex, const PackedPoint* points,
                                    std::size_t count, float* x, float* y, float* z)
{
    const std::int32_t apexX = lattice.x(apex), apexY = lattice.y(apex), apexZ = lattice.z(apex);
    const PackedLattice local = lattice;
    for (std::size_t i = 0; i < count; i += relocationLanes) {
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
TETRA_SIMD_CLONES void makeKeys(const double* errors, const PackedPoint* points, std::size_t count, std::uint64_t* keys)
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

TETRA_SIMD_CLONES void Relocation::findWorst(std::size_t faceCount)
{
    keys_.resize(points_.size());
    makeKeys(errors_.data(), points_.data(), points_.size(), keys_.data());
    faces_.resize(faceCount);
    FacePoints* const faces = faces_.data();
    std::fill_n(faces, faceCount, FacePoints{0, 0});
    for (std::size_t i = 0; i < points_.size(); ++i) {
        FacePoints& face = faces[owners_[i]];
        face.worst = std::max(face.worst, keys_[i]);
        ++face.count;
    }
}

void Relocation::run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                     std::span<const PackedPoint> points)
{
    // The first insertions move millions of points, the later ones dozens: give the room of the first back.
    constexpr std::size_t roomWorthKeeping = 65536;
    if (points_.capacity() > std::max(roomWorthKeeping, 16 * points.size()))
        *this = Relocation();
    // The padding repeats the apex, which every tetrahedron has.
    const std::size_t padded = (points.size() + relocationLanes - 1) / relocationLanes * relocationLanes;
    points_.resize(padded);
    std::ranges::copy(points, points_.begin());
    std::fill(points_.begin() + static_cast<std::ptrdiff_t>(points.size()), points_.end(), star.apex());
    for (Buffer<float>* coordinates : {&x_, &y_, &z_})
        coordinates->resize(padded);
    owners_.resize(padded);
    errors_.resize(padded);
    unpackPoints(lattice, star.apex(), points_.data(), padded, x_.data(), y_.data(), z_.data());
    findCones(star, {x_, y_, z_}, planes_, owners_);
    computeErrors(lattice, samples, star, {points_, owners_, x_, y_, z_}, room_, errors_);
    points_.resize(points.size());
    findWorst(star.faceCount());
}

} // namespace tetra
