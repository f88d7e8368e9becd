// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/relocation.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

constexpr std::size_t lanes = Star::lanes;

/// The largest coordinate for which every sum of the plane tests, at most 6 c^3, is exact in a float.
constexpr std::int32_t exactReachOfFloat = 140;

/// owner[i] = the first face whose cone, seen from the apex, contains point i. `planes` holds nine arrays of `count` (a
/// multiple of `lanes`): the normals of the three sides. Branch free: every face is tested.
template <class Real>
[[gnu::always_inline]] inline void findOwnersIn(std::size_t count, const Real* planes, std::size_t pointCount,
                                                const float* x, const float* y, const float* z, std::uint32_t* owners)
{
    for (std::size_t i = 0; i < pointCount; ++i) {
        const Real px = x[i], py = y[i], pz = z[i];
        std::int32_t first[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane)
            first[lane] = 0x7fffffff;
        for (std::size_t base = 0; base < count; base += lanes)
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const Real* const plane = planes + base + lane;
                const Real side0 = plane[0] * px + plane[count] * py + plane[2 * count] * pz;
                const Real side1 = plane[3 * count] * px + plane[4 * count] * py + plane[5 * count] * pz;
                const Real side2 = plane[6 * count] * px + plane[7 * count] * py + plane[8 * count] * pz;
                const bool inside = (side0 >= 0) & (side1 >= 0) & (side2 >= 0);
                const std::int32_t candidate = inside ? static_cast<std::int32_t>(base + lane) : 0x7fffffff;
                first[lane] = candidate < first[lane] ? candidate : first[lane];
            }
        std::int32_t owner = first[0];
        for (std::size_t lane = 1; lane < lanes; ++lane)
            owner = first[lane] < owner ? first[lane] : owner;
        owners[i] = static_cast<std::uint32_t>(owner);
    }
}

TETRA_SIMD_CLONES void findOwnersFloat(std::size_t count, const float* planes, std::size_t pointCount, const float* x,
                                       const float* y, const float* z, std::uint32_t* owners)
{
    findOwnersIn(count, planes, pointCount, x, y, z, owners);
}

TETRA_SIMD_CLONES void findOwnersDouble(std::size_t count, const double* planes, std::size_t pointCount, const float* x,
                                        const float* y, const float* z, std::uint32_t* owners)
{
    findOwnersIn(count, planes, pointCount, x, y, z, owners);
}

} // namespace

template <class Real> void Relocation::findOwners(const Star& star)
{
    const std::size_t count = star.paddedFaceCount();
    planes_.resize(9 * count);
    Real* const planes = reinterpret_cast<Real*>(planes_.data());
    const double* const normals = star.quantity(Star::NormalBC);
    for (std::size_t i = 0; i < 9 * count; ++i)
        planes[i] = static_cast<Real>(normals[i]);
    if constexpr (sizeof(Real) == sizeof(float))
        findOwnersFloat(count, planes, points_.size(), x_.data(), y_.data(), z_.data(), owners_.data());
    else
        findOwnersDouble(count, planes, points_.size(), x_.data(), y_.data(), z_.data(), owners_.data());
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
    x_.resize(count);
    y_.resize(count);
    z_.resize(count);
    owners_.resize(count);
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
    for (const std::uint32_t owner : owners_)
        ++offsets_[owner + 2];
    for (std::size_t face = 2; face < offsets_.size(); ++face)
        offsets_[face] += offsets_[face - 1];
    const std::size_t count = points_.size();
    placed_.resize(count);
    placedX_.resize(count);
    placedY_.resize(count);
    placedZ_.resize(count);
    placedOwners_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = offsets_[owners_[i] + 1]++;
        placed_[place] = points_[i];
        placedX_[place] = x_[i];
        placedY_[place] = y_[i];
        placedZ_[place] = z_[i];
        placedOwners_[place] = owners_[i];
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
    if (star.reach() <= exactReachOfFloat)
        findOwners<float>(star);
    else
        findOwners<double>(star);
    sortByOwner(star.faceCount());
    computeErrors(lattice, samples, star);
}

} // namespace tetra
