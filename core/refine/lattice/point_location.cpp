// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/point_location.h"

#include "core/base/simd.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <cstring>

namespace tetra {

std::array<std::int64_t, 4> volumesAt(const PackedLattice& lattice, PackedPoint point,
                                      const std::array<PackedPoint, 4>& vertices)
{
    std::array<std::array<std::int64_t, 3>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = {lattice.x(vertices[i]) - lattice.x(point), lattice.y(vertices[i]) - lattice.y(point),
                      lattice.z(vertices[i]) - lattice.z(point)};
    const auto cross = [](const auto& a, const auto& b) -> std::array<std::int64_t, 3> {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto dot = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto& [a, b, c, d] = corners;
    const std::array<std::int64_t, 3> ab = cross(a, b), cd = cross(c, d);
    return {dot(b, cd), -dot(a, cd), dot(d, ab), -dot(c, ab)};
}

namespace {

/// A point on its way, by its coordinates, and the tetrahedron that it has come to.
struct Walk {
    std::int32_t x, y, z;
    std::uint32_t slot;
};

/// Across the face that the point is farthest beyond. False if there is none, or nothing behind it: then the walk has
/// ended.
TETRA_SIMD_INLINE bool walkOn(const LatticeDelaunay& mesh, const PackedLattice& lattice, Walk& walk)
{
    const DelaunayTetrahedron& tetrahedron = mesh[walk.slot];
    Int4 vertices, offsetX, offsetY, offsetZ;
    std::memcpy(&vertices, &tetrahedron.vertices, sizeof vertices);
    lattice.unpack(vertices, offsetX, offsetY, offsetZ);
    const Double4 x = __builtin_convertvector(offsetX - walk.x, Double4);
    const Double4 y = __builtin_convertvector(offsetY - walk.y, Double4);
    const Double4 z = __builtin_convertvector(offsetZ - walk.z, Double4);
    // Six times the volume of the point with the face opposite to each vertex: a . (b x c) of the other three.
    const Double4 firstX = __builtin_shufflevector(x, x, 1, 0, 3, 2),
                  firstY = __builtin_shufflevector(y, y, 1, 0, 3, 2),
                  firstZ = __builtin_shufflevector(z, z, 1, 0, 3, 2);
    const Double4 secondX = __builtin_shufflevector(x, x, 2, 3, 0, 1),
                  secondY = __builtin_shufflevector(y, y, 2, 3, 0, 1),
                  secondZ = __builtin_shufflevector(z, z, 2, 3, 0, 1);
    const Double4 thirdX = __builtin_shufflevector(x, x, 3, 2, 1, 0),
                  thirdY = __builtin_shufflevector(y, y, 3, 2, 1, 0),
                  thirdZ = __builtin_shufflevector(z, z, 3, 2, 1, 0);
    const Double4 volume = firstX * (secondY * thirdZ - secondZ * thirdY) +
                           firstY * (secondZ * thirdX - secondX * thirdZ) +
                           firstZ * (secondX * thirdY - secondY * thirdX);
    std::uint32_t least = 0;
    double leastVolume = volume[0];
    for (std::uint32_t face = 1; face < 4; ++face) {
        least = volume[face] < leastVolume ? face : least;
        leastVolume = std::min(leastVolume, volume[face]);
    }
    if (!(leastVolume < 0))
        return false;
    walk.slot = tetrahedron.neighbours[least];
    return walk.slot != LatticeDelaunay::none;
}

TETRA_SIMD_INLINE void walkTogether(const LatticeDelaunay& mesh, const PackedPoint* points, std::uint32_t* slots,
                                    std::size_t count)
{
    constexpr std::size_t atOnce = 8;
    const PackedLattice lattice = mesh.lattice();
    std::array<Walk, atOnce> walks;
    std::array<std::size_t, atOnce> numbers;
    std::size_t walking = 0, next = 0;
    const auto begin = [&](std::size_t i) {
        const PackedPoint point = points[next];
        walks[i] = {lattice.x(point), lattice.y(point), lattice.z(point), slots[next]};
        numbers[i] = next++;
        mesh.prefetch(walks[i].slot);
    };
    while (walking < atOnce && next < count)
        begin(walking++);
    while (walking > 0)
        for (std::size_t i = 0; i < walking;) {
            if (walkOn(mesh, lattice, walks[i])) {
                mesh.prefetch(walks[i++].slot);
                continue;
            }
            slots[numbers[i]] = walks[i].slot;
            if (next < count) {
                begin(i++);
            } else {
                --walking;
                walks[i] = walks[walking];
                numbers[i] = numbers[walking];
            }
        }
}

TETRA_SIMD_INLINE std::uint32_t walkAlone(const LatticeDelaunay& mesh, PackedPoint point, std::uint32_t slot)
{
    const PackedLattice lattice = mesh.lattice();
    Walk walk{lattice.x(point), lattice.y(point), lattice.z(point), slot};
    while (walkOn(mesh, lattice, walk)) {
    }
    return walk.slot;
}

} // namespace

void locate(const LatticeDelaunay& delaunay, std::span<const PackedPoint> points, std::span<std::uint32_t> slots)
{
    dispatch<walkTogether>(delaunay, points.data(), slots.data(), points.size());
}

PlacedPoint placeIn(const LatticeDelaunay& delaunay, PackedPoint point, std::uint32_t slot)
{
    const std::uint32_t found = dispatch<walkAlone>(delaunay, point, slot);
    if (found == LatticeDelaunay::none)
        return {};
    return {found, volumesAt(delaunay.lattice(), point, delaunay[found].vertices)};
}

std::uint32_t walkByFirstFace(const LatticeDelaunay& delaunay, PackedPoint point, std::uint32_t slot)
{
    for (;;) {
        const DelaunayTetrahedron& tetrahedron = delaunay[slot];
        std::uint32_t next = slot;
        for (std::size_t face = 0; face < 4 && next == slot; ++face) {
            if (!onInnerSide(delaunay.lattice(), point, withCornerFirst(tetrahedron.vertices, face)))
                next = tetrahedron.neighbours[face];
        }
        if (next == slot)
            return slot;
        slot = next;
    }
}

} // namespace tetra
