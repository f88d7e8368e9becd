// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lattice_walk.h"

#include "core/mesh/topology.h"

namespace tetra {

bool onInnerSide(const PackedLattice& lattice, PackedPoint point, const std::array<PackedPoint, 4>& vertices)
{
    const auto offset = [&](PackedPoint vertex) -> std::array<std::int64_t, 3> {
        return {lattice.x(vertex) - lattice.x(point), lattice.y(vertex) - lattice.y(point),
                lattice.z(vertex) - lattice.z(point)};
    };
    const auto a = offset(vertices[1]), b = offset(vertices[2]), c = offset(vertices[3]);
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) >=
           0;
}

std::uint32_t walkTo(const LatticeDelaunay& delaunay, PackedPoint point, std::uint32_t slot)
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
