// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/star.h"

#include "core/base/simd.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace tetra {

namespace {

/// `rim` holds x, y, z and the weighted square of each vertex.
TETRA_SIMD_CLONES void computeFaces(std::span<const std::array<std::uint32_t, 3>> corners,
                                    const std::array<double, 4>* rim, Star::Face* faces)
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Double4 a, b, c;
        std::memcpy(&a, &rim[corners[i][0]], sizeof a);
        std::memcpy(&b, &rim[corners[i][1]], sizeof b);
        std::memcpy(&c, &rim[corners[i][2]], sizeof c);
        // A cross product is u.yzx * v.zxy - u.zxy * v.yzx; the fourth lanes cancel to 0.
        const Double4 aYzx = __builtin_shufflevector(a, a, 1, 2, 0, 3),
                      aZxy = __builtin_shufflevector(a, a, 2, 0, 1, 3);
        const Double4 bYzx = __builtin_shufflevector(b, b, 1, 2, 0, 3),
                      bZxy = __builtin_shufflevector(b, b, 2, 0, 1, 3);
        const Double4 cYzx = __builtin_shufflevector(c, c, 1, 2, 0, 3),
                      cZxy = __builtin_shufflevector(c, c, 2, 0, 1, 3);
        const Double4 bc = bYzx * cZxy - bZxy * cYzx;
        const Double4 ca = cYzx * aZxy - cZxy * aYzx;
        const Double4 ab = aYzx * bZxy - aZxy * bYzx;
        Double4 sphere = a[3] * bc + b[3] * ca + c[3] * ab;
        const Double4 products = a * bc;
        sphere[3] = products[0] + products[1] + products[2];
        std::memcpy(&faces[i].normalBC, &bc, sizeof bc);
        std::memcpy(&faces[i].normalCA, &ca, sizeof ca);
        std::memcpy(&faces[i].normalAB, &ab, sizeof ab);
        std::memcpy(&faces[i].sphere, &sphere, sizeof sphere);
    }
}

} // namespace

Status Star::attach(const PackedLattice& lattice)
{
    lattice_ = &lattice;
    // Stamps of another lattice in the same memory count as old ones.
    rimStart_ += rimCount_;
    rimCount_ = 0;
    rim_.resize(64);
    const auto& size = lattice.size();
    return stamps_.ensure(std::uint64_t(size[0]) * size[1] * size[2], "the marks of the refinement's points");
}

void Star::clear(PackedPoint apex)
{
    apex_ = apex;
    rimStart_ += rimCount_;
    rimCount_ = 0;
    corners_.clear();
    // After four thousand million rim vertices the stamps begin anew.
    if (rimStart_ > std::numeric_limits<std::uint32_t>::max() / 2) {
        std::fill_n(stamps_.data(), stamps_.capacity(), 0u);
        rimStart_ = 0;
    }
}

void Star::finish(const std::array<double, 3>& weights)
{
    const std::int32_t apexX = lattice_->x(apex_), apexY = lattice_->y(apex_), apexZ = lattice_->z(apex_);
    rimCoordinates_.resize(rimCount_);
    double reach = 0;
    for (std::size_t i = 0; i < rimCount_; ++i) {
        const double x = lattice_->x(rim_[i]) - apexX;
        const double y = lattice_->y(rim_[i]) - apexY;
        const double z = lattice_->z(rim_[i]) - apexZ;
        reach = std::max(reach, std::max(std::abs(x), std::max(std::abs(y), std::abs(z))));
        rimCoordinates_[i] = {x, y, z, weights[0] * x * x + weights[1] * y * y + weights[2] * z * z};
    }
    reach_ = reach;
    faces_.resize(corners_.size());
    computeFaces(corners_, rimCoordinates_.data(), faces_.data());
}

std::span<const std::array<std::uint32_t, 3>> Star::partners()
{
    if (rimCount_ > edgeStride_) {
        edgeStride_ = std::bit_ceil(std::max<std::size_t>(rimCount_, 32));
        edges_.assign(edgeStride_ * edgeStride_, 0);
    }
    // An edge (u, v) of one face is (v, u) of its partner. Three passes without a branch: note, look up, clear.
    const std::uint32_t count = static_cast<std::uint32_t>(corners_.size());
    const std::size_t stride = edgeStride_;
    std::uint32_t* const edges = edges_.data();
    partners_.resize(count);
    for (std::uint32_t face = 0; face < count; ++face) {
        const std::size_t a = corners_[face][0], b = corners_[face][1], c = corners_[face][2];
        edges[b * stride + c] = edges[c * stride + a] = edges[a * stride + b] = face + 1;
    }
    for (std::uint32_t face = 0; face < count; ++face) {
        const std::size_t a = corners_[face][0], b = corners_[face][1], c = corners_[face][2];
        partners_[face] = {edges[c * stride + b] - 1, edges[a * stride + c] - 1, edges[b * stride + a] - 1};
    }
    for (std::uint32_t face = 0; face < count; ++face) {
        const std::size_t a = corners_[face][0], b = corners_[face][1], c = corners_[face][2];
        edges[b * stride + c] = edges[c * stride + a] = edges[a * stride + b] = 0;
    }
    return partners_;
}

} // namespace tetra
