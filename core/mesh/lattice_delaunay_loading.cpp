// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_matching.h"
#include "core/mesh/lattice_delaunay.h"

#include <algorithm>
#include <cstring>

namespace tetra {

namespace {

using Offset = std::array<double, 3>;

/// Tetrahedra between two looks at whether the work was cancelled.
constexpr std::size_t loadedAtOnce = 1 << 16;

Offset offset(const PackedLattice& lattice, PackedPoint from, PackedPoint to)
{
    return {static_cast<double>(lattice.x(to) - lattice.x(from)), static_cast<double>(lattice.y(to) - lattice.y(from)),
            static_cast<double>(lattice.z(to) - lattice.z(from))};
}

Offset crossOf(const Offset& a, const Offset& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double square(const Offset& a, const std::array<double, 3>& weights)
{
    return weights[0] * a[0] * a[0] + weights[1] * a[1] * a[1] + weights[2] * a[2] * a[2];
}

/// As Star computes it.
std::array<double, 4> sphereOf(const PackedLattice& lattice, const std::array<PackedPoint, 4>& vertices,
                               const std::array<double, 3>& weights)
{
    const Offset a = offset(lattice, vertices[0], vertices[1]);
    const Offset b = offset(lattice, vertices[0], vertices[2]);
    const Offset c = offset(lattice, vertices[0], vertices[3]);
    const Offset bc = crossOf(b, c), ca = crossOf(c, a), ab = crossOf(a, b);
    const double squareA = square(a, weights), squareB = square(b, weights), squareC = square(c, weights);
    std::array<double, 4> sphere{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        sphere[axis] = squareA * bc[axis] + squareB * ca[axis] + squareC * ab[axis];
    sphere[3] = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    return sphere;
}

/// Which of the four faces lie in planes that bound blocks, as bits; none for a tetrahedron that is in no single block.
struct BorderFaces {
    std::uint32_t bits = 0;
    bool inOneBlock = true;
};

BorderFaces borderFaces(const PackedLattice& lattice, const BlockDivision& division,
                        const std::array<PackedPoint, 4>& vertices)
{
    BorderFaces faces;
    const auto look = [&](std::size_t axis, auto coordinate) {
        const std::array<std::int32_t, 4> c = {coordinate(vertices[0]), coordinate(vertices[1]),
                                               coordinate(vertices[2]), coordinate(vertices[3])};
        const std::int32_t least = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
        const std::int32_t largest = std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
        if (least == largest)
            return;
        faces.inOneBlock &= division.blockAlong(axis, static_cast<std::uint32_t>(least)) ==
                            division.blockAlong(axis, static_cast<std::uint32_t>(largest - 1));
        for (const std::int32_t plane : {least, largest}) {
            if (!division.isBorder(axis, static_cast<std::uint32_t>(plane)))
                continue;
            const std::uint32_t off = (c[0] != plane) | (c[1] != plane) << 1 | (c[2] != plane) << 2 |
                                      static_cast<std::uint32_t>(c[3] != plane) << 3;
            if ((off & (off - 1)) == 0)
                faces.bits |= off;
        }
    };
    look(0, [&](PackedPoint p) { return lattice.x(p); });
    look(1, [&](PackedPoint p) { return lattice.y(p); });
    look(2, [&](PackedPoint p) { return lattice.z(p); });
    return faces;
}

} // namespace

MeshLoading LatticeDelaunay::load(std::span<const std::array<PackedPoint, 4>> tetrahedra, const BlockDivision& division,
                                  const Progress& progress)
{
    slotCount_ = 0;
    freeSlots_.clear();
    if (tetrahedra.size() > slotCapacity_ || tetrahedra.size() >= (1u << 30))
        return MeshLoading::NoMesh;
    if (const MeshLoading loaded = loadTetrahedra(tetrahedra, division, progress); loaded != MeshLoading::Done)
        return loaded;
    slotCount_ = static_cast<std::uint32_t>(tetrahedra.size());
    return checkDelaunay(progress);
}

MeshLoading LatticeDelaunay::loadTetrahedra(std::span<const std::array<PackedPoint, 4>> tetrahedra,
                                            const BlockDivision& division, const Progress& progress)
{
    constexpr std::size_t atOnce = 16;
    FaceMatching matching(4 * tetrahedra.size());
    std::array<std::array<std::uint64_t, 4>, atOnce> keys{};
    std::array<std::uint32_t, atOnce> borders{};
    std::uint64_t volume = 0;
    for (std::size_t first = 0; first < tetrahedra.size(); first += atOnce) {
        if (first % loadedAtOnce == 0 && progress.cancelled())
            return MeshLoading::Cancelled;
        const std::size_t count = std::min(atOnce, tetrahedra.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const std::array<PackedPoint, 4>& vertices = tetrahedra[first + i];
            DelaunayTetrahedron& record = records()[first + i];
            record = {vertices, {none, none, none, none}, sphereOf(lattice_, vertices, weights_)};
            const BorderFaces faces = borderFaces(lattice_, division, vertices);
            if (!(record.determinant() > 0) || !faces.inOneBlock)
                return MeshLoading::NoMesh;
            volume += static_cast<std::uint64_t>(record.determinant());
            borders[i] = faces.bits;
            std::uint64_t sum = 0;
            for (std::size_t k = 0; k < 4; ++k)
                sum += keys[i][k] = FaceMatching::keyOf(vertices[k]);
            for (std::size_t k = 0; k < 4; ++k) {
                keys[i][k] = sum - keys[i][k];
                matching.prefetch(keys[i][k]);
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            for (std::uint32_t face = 0; face < 4; ++face) {
                if ((borders[i] >> face & 1) != 0)
                    continue;
                const auto side = static_cast<std::uint32_t>(4 * (first + i) + face);
                const std::uint32_t other = matching.add(keys[i][face], side);
                if (other == FaceMatching::none)
                    continue;
                if (other / 4 == side / 4)
                    return MeshLoading::NoMesh;
                records()[first + i].neighbours[face] = other / 4;
                records()[other / 4].neighbours[other % 4] = static_cast<std::uint32_t>(first + i);
            }
    }
    const auto& size = lattice_.size();
    const bool covers = volume == 6 * (size[0] - 1ull) * (size[1] - 1ull) * (size[2] - 1ull);
    return matching.singleCount() == 0 && covers ? MeshLoading::Done : MeshLoading::NoMesh;
}

/// Whether no vertex lies strictly inside the circumsphere of a neighbour: then none does anywhere.
MeshLoading LatticeDelaunay::checkDelaunay(const Progress& progress) const
{
    for (std::uint32_t slot = 0; slot < slotCount_; ++slot) {
        if (slot % loadedAtOnce == 0 && progress.cancelled())
            return MeshLoading::Cancelled;
        const DelaunayTetrahedron& one = at(slot);
        for (const std::uint32_t neighbour : one.neighbours) {
            if (neighbour == none || neighbour < slot)
                continue;
            const DelaunayTetrahedron& other = at(neighbour);
            std::uint32_t shared = 0;
            PackedPoint opposite = 0;
            for (const PackedPoint vertex : other.vertices) {
                const bool known = std::ranges::find(one.vertices, vertex) != one.vertices.end();
                shared += known;
                opposite = known ? opposite : vertex;
            }
            const Offset q = offset(lattice_, one.vertices[0], opposite);
            const auto& sphere = one.sphere;
            if (shared != 3)
                return MeshLoading::NoMesh;
            if (sphere[3] * square(q, weights_) < sphere[0] * q[0] + sphere[1] * q[1] + sphere[2] * q[2])
                return MeshLoading::NotDelaunay;
        }
    }
    return MeshLoading::Done;
}

void LatticeDelaunay::restore(std::span<const DelaunayTetrahedron> tetrahedra, std::span<const std::uint32_t> changed)
{
    // What lay beside a changed one may have stayed and got another neighbour.
    for (const std::uint32_t slot : changed) {
        records()[slot] = tetrahedra[slot];
        for (const std::uint32_t neighbour : tetrahedra[slot].neighbours)
            if (neighbour != none)
                records()[neighbour].neighbours = tetrahedra[neighbour].neighbours;
    }
    slotCount_ = static_cast<std::uint32_t>(tetrahedra.size());
    freeSlots_.clear();
}

} // namespace tetra
