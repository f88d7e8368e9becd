// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/relocation.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tetra {

namespace {

/// The largest coordinate for which every sum of the plane tests, at most 6 c^3, is exact in a float.
constexpr std::int32_t exactReachOfFloat = 140;

/// Points are tested this many at a time.
constexpr std::size_t lanes = 8;

template <class Real> struct Vector;
template <> struct Vector<float> {
    using Type = float __attribute__((vector_size(lanes * sizeof(float))));
    using Mask = std::int32_t __attribute__((vector_size(lanes * sizeof(float))));
};
template <> struct Vector<double> {
    using Type = double __attribute__((vector_size(lanes * sizeof(double))));
    using Mask = std::int64_t __attribute__((vector_size(lanes * sizeof(double))));
};

/// owners[i] = the last face whose cone, seen from the apex, contains point i. `planes` holds nine numbers for each
/// face, the normals of the three sides of its cone. Branch free: every face is tested, for `lanes` points at a time;
/// the point arrays are padded to that.
template <class Real>
[[gnu::always_inline]] inline void findOwnersIn(std::span<const Real> planes, std::size_t pointCount, const float* x,
                                                const float* y, const float* z, std::int32_t* owners)
{
    using Numbers = typename Vector<Real>::Type;
    using Mask = typename Vector<Real>::Mask;
    const auto load = [](Numbers& to, const float* from) {
        Vector<float>::Type numbers;
        std::memcpy(&numbers, from, sizeof numbers);
        to = __builtin_convertvector(numbers, Numbers);
    };
    for (std::size_t i = 0; i < pointCount; i += lanes) {
        Numbers px, py, pz;
        load(px, x + i);
        load(py, y + i);
        load(pz, z + i);
        Mask owner = {};
        Mask face = {};
        for (const Real* plane = planes.data(); plane != planes.data() + planes.size(); plane += 9) {
            const Numbers side0 = plane[0] * px + plane[1] * py + plane[2] * pz;
            const Numbers side1 = plane[3] * px + plane[4] * py + plane[5] * pz;
            const Numbers side2 = plane[6] * px + plane[7] * py + plane[8] * pz;
            const Mask inside = (side0 >= 0) & (side1 >= 0) & (side2 >= 0);
            owner = inside ? face : owner;
            face += 1;
        }
        const auto narrow = __builtin_convertvector(owner, Vector<float>::Mask);
        std::memcpy(owners + i, &narrow, sizeof narrow);
    }
}

TETRA_SIMD_CLONES void findOwnersFloat(std::span<const float> planes, std::size_t pointCount, const float* x,
                                       const float* y, const float* z, std::int32_t* owners)
{
    findOwnersIn<float>(planes, pointCount, x, y, z, owners);
}

TETRA_SIMD_CLONES void findOwnersDouble(std::span<const double> planes, std::size_t pointCount, const float* x,
                                        const float* y, const float* z, std::int32_t* owners)
{
    findOwnersIn<double>(planes, pointCount, x, y, z, owners);
}

template <class Real> std::span<const Real> facePlanes(const Star& star, std::vector<Real>& planes)
{
    planes.resize(9 * star.faceCount());
    const std::size_t stride = star.paddedFaceCount();
    const double* const normals = star.quantity(Star::NormalBC);
    for (std::size_t face = 0; face < star.faceCount(); ++face)
        for (std::size_t k = 0; k < 9; ++k)
            planes[9 * face + k] = static_cast<Real>(normals[k * stride + face]);
    return planes;
}

} // namespace

void Relocation::findOwners(const Star& star)
{
    if (star.reach() <= exactReachOfFloat)
        findOwnersFloat(facePlanes(star, floatPlanes_), points_.size(), x_.data(), y_.data(), z_.data(),
                        owners_.data());
    else
        findOwnersDouble(facePlanes(star, doublePlanes_), points_.size(), x_.data(), y_.data(), z_.data(),
                         owners_.data());
}

void Relocation::gatherCoordinates(const PackedLattice& lattice, PackedPoint apex, std::span<const PackedPoint> points)
{
    points_.resize(points.size());
    std::size_t count = 0;
    for (const PackedPoint point : points) {
        points_[count] = point;
        count += point != apex;
    }
    points_.resize(count);
    const std::size_t padded = (count + lanes - 1) / lanes * lanes;
    x_.resize(padded);
    y_.resize(padded);
    z_.resize(padded);
    owners_.resize(padded);
    const std::int32_t apexX = lattice.x(apex), apexY = lattice.y(apex), apexZ = lattice.z(apex);
    for (std::size_t i = 0; i < count; ++i) {
        x_[i] = static_cast<float>(lattice.x(points_[i]) - apexX);
        y_[i] = static_cast<float>(lattice.y(points_[i]) - apexY);
        z_[i] = static_cast<float>(lattice.z(points_[i]) - apexZ);
    }
}

void Relocation::sortByOwner(std::size_t faceCount)
{
    offsets_.assign(faceCount + 2, 0);
    for (std::size_t i = 0; i < points_.size(); ++i)
        ++offsets_[static_cast<std::size_t>(owners_[i]) + 2];
    for (std::size_t face = 2; face < offsets_.size(); ++face)
        offsets_[face] += offsets_[face - 1];
    const std::size_t count = points_.size();
    placed_.resize(count);
    placedX_.resize(count);
    placedY_.resize(count);
    placedZ_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = offsets_[static_cast<std::size_t>(owners_[i]) + 1]++;
        placed_[place] = points_[i];
        placedX_[place] = x_[i];
        placedY_[place] = y_[i];
        placedZ_[place] = z_[i];
    }
    offsets_.pop_back();
}

void Relocation::computeErrors(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star)
{
    const std::span<const PackedPoint> rim = star.rim();
    const PackedPoint apex = star.apex();
    double apexValue = 0;
    samples.gather(lattice, {&apex, 1}, &apexValue);
    rimValues_.resize(rim.size());
    samples.gather(lattice, rim, rimValues_.data());
    values_.resize(placed_.size());
    samples.gather(lattice, placed_, values_.data());
    scaledErrors_.resize(placed_.size());

    const std::size_t count = star.paddedFaceCount();
    const double* const bc = star.quantity(Star::NormalBC);
    const double* const ca = star.quantity(Star::NormalCA);
    const double* const ab = star.quantity(Star::NormalAB);
    const double* const determinant = star.quantity(Star::Determinant);
    for (std::size_t face = 0; face + 1 < offsets_.size(); ++face) {
        if (offsets_[face] == offsets_[face + 1])
            continue;
        const std::array<std::uint32_t, 3>& corners = star.faces()[face];
        const double a = rimValues_[corners[0]] - apexValue;
        const double b = rimValues_[corners[1]] - apexValue;
        const double c = rimValues_[corners[2]] - apexValue;
        const double slopeX = a * bc[face] + b * ca[face] + c * ab[face];
        const double slopeY = a * bc[face + count] + b * ca[face + count] + c * ab[face + count];
        const double slopeZ = a * bc[face + 2 * count] + b * ca[face + 2 * count] + c * ab[face + 2 * count];
        for (std::uint32_t i = offsets_[face]; i < offsets_[face + 1]; ++i)
            scaledErrors_[i] = std::abs(determinant[face] * (values_[i] - apexValue) - slopeX * placedX_[i] -
                                        slopeY * placedY_[i] - slopeZ * placedZ_[i]);
    }
}

void Relocation::run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                     std::span<const PackedPoint> points)
{
    gatherCoordinates(lattice, star.apex(), points);
    findOwners(star);
    sortByOwner(star.faceCount());
    computeErrors(lattice, samples, star);
}

} // namespace tetra
