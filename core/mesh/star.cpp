// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/star.h"

#include "core/base/simd.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace tetra {

namespace {

/// Normals, determinants and spheres of `count` faces (a multiple of Star::lanes). `corners` holds twelve arrays: x, y,
/// z and the weighted square of a, then of b, then of c.
TETRA_SIMD_CLONES void computeFaces(std::size_t count, const double* corners, double* values)
{
    const double* const a = corners;
    const double* const b = corners + 4 * count;
    const double* const c = corners + 8 * count;
    for (std::size_t i = 0; i < count; ++i) {
        const double ax = a[i], ay = a[i + count], az = a[i + 2 * count], aa = a[i + 3 * count];
        const double bx = b[i], by = b[i + count], bz = b[i + 2 * count], bb = b[i + 3 * count];
        const double cx = c[i], cy = c[i + count], cz = c[i + 2 * count], cc = c[i + 3 * count];
        const double bcx = by * cz - bz * cy, bcy = bz * cx - bx * cz, bcz = bx * cy - by * cx;
        const double cax = cy * az - cz * ay, cay = cz * ax - cx * az, caz = cx * ay - cy * ax;
        const double abx = ay * bz - az * by, aby = az * bx - ax * bz, abz = ax * by - ay * bx;
        values[i] = bcx, values[i + count] = bcy, values[i + 2 * count] = bcz;
        values[i + 3 * count] = cax, values[i + 4 * count] = cay, values[i + 5 * count] = caz;
        values[i + 6 * count] = abx, values[i + 7 * count] = aby, values[i + 8 * count] = abz;
        values[i + 9 * count] = ax * bcx + ay * bcy + az * bcz;
        values[i + 10 * count] = aa * bcx + bb * cax + cc * abx;
        values[i + 11 * count] = aa * bcy + bb * cay + cc * aby;
        values[i + 12 * count] = aa * bcz + bb * caz + cc * abz;
    }
}

} // namespace

void Star::clear(const PackedLattice& lattice, PackedPoint apex)
{
    lattice_ = &lattice;
    apex_ = apex;
    reach_ = 0;
    rim_.clear();
    faces_.clear();
    for (const std::uint32_t slot : hashUsed_)
        hash_[slot].position = 0;
    hashUsed_.clear();
}

std::uint32_t Star::rimPosition(PackedPoint point)
{
    const std::uint32_t mask = static_cast<std::uint32_t>(hash_.size()) - 1;
    std::uint32_t slot = (point * 0x9e3779b1u >> 7) & mask;
    while (hash_[slot].position != 0) {
        if (hash_[slot].point == point)
            return hash_[slot].position - 1;
        slot = (slot + 1) & mask;
    }
    rim_.push_back(point);
    hash_[slot] = {point, static_cast<std::uint32_t>(rim_.size())};
    hashUsed_.push_back(slot);
    if (rim_.size() * 2 > hash_.size())
        growHash();
    return static_cast<std::uint32_t>(rim_.size()) - 1;
}

void Star::growHash()
{
    hash_.assign(hash_.size() * 4, HashEntry{});
    hashUsed_.clear();
    const std::uint32_t mask = static_cast<std::uint32_t>(hash_.size()) - 1;
    for (std::uint32_t position = 0; position < rim_.size(); ++position) {
        std::uint32_t slot = (rim_[position] * 0x9e3779b1u >> 7) & mask;
        while (hash_[slot].position != 0)
            slot = (slot + 1) & mask;
        hash_[slot] = {rim_[position], position + 1};
        hashUsed_.push_back(slot);
    }
}

void Star::addFace(PackedPoint a, PackedPoint b, PackedPoint c)
{
    faces_.push_back({rimPosition(a), rimPosition(b), rimPosition(c)});
}

void Star::finish(const std::array<double, 3>& weights)
{
    const std::int32_t apexX = lattice_->x(apex_), apexY = lattice_->y(apex_), apexZ = lattice_->z(apex_);
    rimCoordinates_.resize(rim_.size() * 4);
    for (std::size_t i = 0; i < rim_.size(); ++i) {
        const std::int32_t x = lattice_->x(rim_[i]) - apexX;
        const std::int32_t y = lattice_->y(rim_[i]) - apexY;
        const std::int32_t z = lattice_->z(rim_[i]) - apexZ;
        reach_ = std::max({reach_, std::abs(x), std::abs(y), std::abs(z)});
        double* const coordinates = rimCoordinates_.data() + 4 * i;
        coordinates[0] = x, coordinates[1] = y, coordinates[2] = z;
        coordinates[3] = weights[0] * coordinates[0] * coordinates[0] + weights[1] * coordinates[1] * coordinates[1] +
                         weights[2] * coordinates[2] * coordinates[2];
    }
    const std::size_t count = paddedFaceCount();
    corners_.resize(12 * count);
    values_.resize(QuantityCount * count);
    for (std::size_t i = 0; i < faces_.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const double* const coordinates = rimCoordinates_.data() + std::size_t(4) * faces_[i][corner];
            for (std::size_t k = 0; k < 4; ++k)
                corners_[(4 * corner + k) * count + i] = coordinates[k];
        }
    for (std::size_t array = 0; array < 12; ++array)
        std::fill_n(corners_.begin() + static_cast<std::ptrdiff_t>(array * count + faces_.size()),
                    count - faces_.size(), 0.0);
    computeFaces(count, corners_.data(), values_.data());
}

std::span<const std::array<std::uint32_t, 3>> Star::partners()
{
    if (rim_.size() > edgeStride_) {
        edgeStride_ = std::bit_ceil(std::max<std::size_t>(rim_.size(), 32));
        edges_.assign(edgeStride_ * edgeStride_, 0);
    }
    // An edge (u, v) of one face is (v, u) of its partner. Three passes without a branch: note, look up, clear.
    const auto edge = [this](std::uint32_t face, std::uint32_t corner, bool reversed) -> std::uint32_t& {
        const std::size_t from = faces_[face][corner == 2 ? 0 : corner + 1];
        const std::size_t to = faces_[face][corner == 0 ? 2 : corner - 1];
        return edges_[reversed ? to * edgeStride_ + from : from * edgeStride_ + to];
    };
    const std::uint32_t count = static_cast<std::uint32_t>(faces_.size());
    partners_.resize(count);
    for (std::uint32_t face = 0; face < count; ++face)
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            edge(face, corner, false) = face + 1;
    for (std::uint32_t face = 0; face < count; ++face)
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            partners_[face][corner] = edge(face, corner, true) - 1;
    for (std::uint32_t face = 0; face < count; ++face)
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            edge(face, corner, false) = 0;
    return partners_;
}

} // namespace tetra
