// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/star.h"

#include "core/base/simd.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::size_t linkLanes = 4;

/// x, y, z relative to the apex and the weighted square of each vertex, a few at a time and so up to linkLanes - 1
/// beyond the last. Gives the largest absolute coordinate.
TETRA_SIMD_INLINE double unpackLink(const PackedLattice& lattice, PackedPoint apex,
                                    const std::array<double, 3>& weights, const PackedPoint* link, std::size_t count,
                                    std::array<double, 4>* coordinates)
{
    const PackedLattice local = lattice;
    const double weightX = weights[0], weightY = weights[1], weightZ = weights[2];
    const std::int32_t apexX = local.x(apex), apexY = local.y(apex), apexZ = local.z(apex);
    Int4 reach = {};
    for (std::size_t i = 0; i < count; i += linkLanes) {
        Int4 packed, offsetX, offsetY, offsetZ;
        std::memcpy(&packed, link + i, sizeof packed);
        local.unpack(packed, offsetX, offsetY, offsetZ);
        offsetX -= apexX;
        offsetY -= apexY;
        offsetZ -= apexZ;
        // Of the two's complement |q| or |q| - 1: near enough for a bound when 1 is added.
        reach |= (offsetX ^ (offsetX >> 31)) | (offsetY ^ (offsetY >> 31)) | (offsetZ ^ (offsetZ >> 31));
        const Double4 x = __builtin_convertvector(offsetX, Double4);
        const Double4 y = __builtin_convertvector(offsetY, Double4);
        const Double4 z = __builtin_convertvector(offsetZ, Double4);
        const Double4 square = weightX * x * x + weightY * y * y + weightZ * z * z;
        const Double4 xy01 = __builtin_shufflevector(x, y, 0, 4, 2, 6),
                      xy23 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
        const Double4 zs01 = __builtin_shufflevector(z, square, 0, 4, 2, 6),
                      zs23 = __builtin_shufflevector(z, square, 1, 5, 3, 7);
        const Double4 rows[4] = {
            __builtin_shufflevector(xy01, zs01, 0, 1, 4, 5), __builtin_shufflevector(xy23, zs23, 0, 1, 4, 5),
            __builtin_shufflevector(xy01, zs01, 2, 3, 6, 7), __builtin_shufflevector(xy23, zs23, 2, 3, 6, 7)};
        std::memcpy(coordinates + i, rows, sizeof rows);
    }
    return 1.0 + static_cast<double>(reach[0] | reach[1] | reach[2] | reach[3]);
}

/// `link` holds x, y, z and the weighted square of each vertex.
TETRA_SIMD_INLINE void computeFaces(std::span<const std::array<std::uint32_t, 3>> corners,
                                    const std::array<double, 4>* link, Star::Face* faces)
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Double4 a, b, c;
        std::memcpy(&a, &link[corners[i][0]], sizeof a);
        std::memcpy(&b, &link[corners[i][1]], sizeof b);
        std::memcpy(&c, &link[corners[i][2]], sizeof c);
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
        std::memcpy(&faces[i].normals[0], &bc, sizeof bc);
        std::memcpy(&faces[i].normals[4], &ca, sizeof ca);
        std::memcpy(&faces[i].normals[8], &ab, sizeof ab);
        std::memcpy(&faces[i].sphere, &sphere, sizeof sphere);
    }
}

} // namespace

Status Star::attach(const PackedLattice& lattice)
{
    lattice_ = &lattice;
    // Stamps of another lattice in the same memory count as old ones.
    linkStart_ += linkCount_;
    linkCount_ = 0;
    const auto& size = lattice.size();
    return marks_.ensure(std::uint64_t(size[0]) * size[1] * size[2],
                         Message::marked("the marks of the refinement's points"));
}

void Star::archive(StateArchive& archive)
{
    const auto& size = lattice_->size();
    archive(linkStart_, linkCount_);
    archive.elements(std::span(marks_.data(), std::uint64_t(size[0]) * size[1] * size[2]));
}

/// After two thousand million link vertices. Memory that was never written is not even read: some kernels give memory
/// to huge pages that are only read.
void Star::beginStampsAnew()
{
    marks_.forEachTouched([](std::span<Mark> marks) {
        for (Mark& mark : marks)
            if (mark.stamp != 0)
                mark.stamp = 0;
    });
    linkStart_ = 0;
}

/// Finds the distinct vertices of the faces. Without a branch on whether one is new, which nobody could predict.
TETRA_SIMD_INLINE void Star::numberLink(std::span<const std::array<PackedPoint, 3>> faces)
{
    linkStart_ += linkCount_;
    if (linkStart_ > std::numeric_limits<std::uint32_t>::max() / 2)
        beginStampsAnew();
    link_.resize(3 * faces.size() + linkLanes);
    labels_.resize(link_.size());
    corners_.resize(faces.size());
    indices_.resize(3 * faces.size());
    latticeIndices(*lattice_, {faces.data()->data(), 3 * faces.size()}, indices_.data());
    const std::uint32_t* index = indices_.data();
    Mark* const marks = marks_.data();
    std::uint32_t* const labels = labels_.data();
    PackedPoint* const link = link_.data();
    std::array<std::uint32_t, 3>* const corners = corners_.data();
    const std::uint32_t start = linkStart_ + 1;
    std::uint32_t count = 0;
    for (std::size_t face = 0; face < faces.size(); ++face)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const PackedPoint point = faces[face][corner];
            Mark& mark = marks[*index++];
            const std::uint32_t known = mark.stamp;
            const bool isNew = known < start;
            const std::uint32_t place = isNew ? count : known - start;
            link[count] = point;
            labels[count] = mark.label;
            mark.stamp = start + place;
            corners[face][corner] = place;
            count += isNew;
        }
    linkCount_ = count;
    std::fill_n(link + count, linkLanes, apex_);
}

void Star::set(PackedPoint apex, std::span<const std::array<PackedPoint, 3>> faces,
               const std::array<double, 3>& weights)
{
    apex_ = apex;
    dispatch<&Star::numberLink>(*this, faces);
    linkCoordinates_.resize(linkCount_ + linkLanes);
    reach_ = dispatch<unpackLink>(*lattice_, apex, weights, link_.data(), linkCount_, linkCoordinates_.data());
    faces_.resize(corners_.size());
    dispatch<computeFaces>(corners_, linkCoordinates_.data(), faces_.data());
}

/// An edge (u, v) of one face is (v, u) of its partner: note, then look up, without a branch.
template <class Stride> TETRA_SIMD_INLINE void Star::linkFaces(std::span<const std::uint32_t> names, Stride stride)
{
    const std::size_t count = corners_.size();
    std::uint32_t* const edges = edges_.data();
    const std::array<std::uint32_t, 3>* const corners = corners_.data();
    std::array<std::uint32_t, 3>* const partners = partners_.data();
    for (std::size_t face = 0; face < count; ++face) {
        const std::size_t a = corners[face][0], b = corners[face][1], c = corners[face][2];
        edges[b * stride + c] = edges[c * stride + a] = edges[a * stride + b] = names[face];
    }
    for (std::size_t face = 0; face < count; ++face) {
        const std::size_t a = corners[face][0], b = corners[face][1], c = corners[face][2];
        partners[face] = {edges[c * stride + b], edges[a * stride + c], edges[b * stride + a]};
    }
}

TETRA_SIMD_INLINE void Star::findPartners(std::span<const std::uint32_t> names, std::uint32_t absent)
{
    constexpr std::size_t usualStride = 32;
    if (linkCount_ > edgeStride_) {
        edgeStride_ = std::bit_ceil(std::max<std::size_t>(linkCount_, usualStride));
        edges_.assign(edgeStride_ * edgeStride_, absent);
    }
    partners_.resize(corners_.size());
    const bool usual = linkCount_ <= usualStride;
    if (usual)
        linkFaces(names, std::integral_constant<std::size_t, usualStride>());
    else
        linkFaces(names, edgeStride_);
    std::fill_n(edges_.data(), linkCount_ * (usual ? usualStride : edgeStride_), absent);
}

std::span<const std::array<std::uint32_t, 3>> Star::partners(std::span<const std::uint32_t> names, std::uint32_t absent)
{
    dispatch<&Star::findPartners>(*this, names, absent);
    return partners_;
}

namespace {

/// The largest coordinate for which every sum of the plane tests, at most 6 c^3, is exact in a float.
constexpr double exactReachOfFloat = 140;

const std::array<double, 12>& normalsOf(const Star::Face& face)
{
    return face.normals;
}
const std::array<float, 12>& normalsOf(const std::array<float, 12>& normals)
{
    return normals;
}

/// The owners of `groups` times eight points from number `i`, which share the loading of the planes. Branch free: every
/// face is tested.
template <std::size_t groups, class Numbers, class Mask, class Face> TETRA_SIMD_INLINE void
findOwnersAt(std::size_t i, std::span<const Face> faces, const LocatedPoints& points, std::int32_t* owners)
{
    const auto load = [i](Numbers& to, std::span<const float> from, std::size_t group) {
        Float8 numbers;
        std::memcpy(&numbers, from.data() + i + group * coneSearchLanes, sizeof numbers);
        to = __builtin_convertvector(numbers, Numbers);
    };
    Numbers x[groups], y[groups], z[groups];
    Mask owner[groups] = {};
    for (std::size_t group = 0; group < groups; ++group) {
        load(x[group], points.x, group);
        load(y[group], points.y, group);
        load(z[group], points.z, group);
    }
    Mask number = {};
    for (const Face& face : faces) {
        const auto* const plane = normalsOf(face).data();
        for (std::size_t group = 0; group < groups; ++group) {
            const Numbers side0 = plane[0] * x[group] + plane[1] * y[group] + plane[2] * z[group];
            const Numbers side1 = plane[4] * x[group] + plane[5] * y[group] + plane[6] * z[group];
            const Numbers side2 = plane[8] * x[group] + plane[9] * y[group] + plane[10] * z[group];
            const Mask inside = (side0 >= 0) & (side1 >= 0) & (side2 >= 0);
            owner[group] = inside ? number : owner[group];
        }
        number += 1;
    }
    for (std::size_t group = 0; group < groups; ++group) {
        const auto narrow = __builtin_convertvector(owner[group], Int8);
        std::memcpy(owners + i + group * coneSearchLanes, &narrow, sizeof narrow);
    }
}

TETRA_SIMD_INLINE void findOwnersFloat(std::span<const Star::Face> faces, std::array<float, 12>* planes,
                                       const LocatedPoints& points, std::span<std::int32_t> owners)
{
    for (std::size_t face = 0; face < faces.size(); ++face)
        for (std::size_t k = 0; k < 12; ++k)
            planes[face][k] = static_cast<float>(faces[face].normals[k]);
    const std::span<const std::array<float, 12>> narrow(planes, faces.size());
    std::size_t i = 0;
    for (; i + coneSearchLanes < owners.size(); i += 2 * coneSearchLanes)
        findOwnersAt<2, Float8, Int8>(i, narrow, points, owners.data());
    if (i < owners.size())
        findOwnersAt<1, Float8, Int8>(i, narrow, points, owners.data());
}

TETRA_SIMD_INLINE void findOwnersDouble(std::span<const Star::Face> faces, const LocatedPoints& points,
                                        std::span<std::int32_t> owners)
{
    for (std::size_t i = 0; i < owners.size(); i += coneSearchLanes)
        findOwnersAt<1, Double8, Long8>(i, faces, points, owners.data());
}

} // namespace

void locateInStar(const Star& star, const LocatedPoints& points, Buffer<std::array<float, 12>>& planes,
                  std::span<std::int32_t> owners)
{
    if (star.reach() <= exactReachOfFloat) {
        planes.resize(star.faceCount());
        dispatch<findOwnersFloat>(star.faces(), planes.data(), points, owners);
    } else {
        dispatch<findOwnersDouble>(star.faces(), points, owners);
    }
}

} // namespace tetra
