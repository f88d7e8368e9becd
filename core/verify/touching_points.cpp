// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/touching_points.h"

#include "core/base/sort_unique.h"
#include "core/geometry/box_tree.h"
#include "core/mesh/tetrahedron_planes.h"
#include "core/verify/exact_cell.h"
#include "core/verify/irregular_original.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace tetra {

std::vector<std::uint32_t> touchingPoints(std::span<const Eigen::Vector3d> positions,
                                          std::span<const Tetrahedron> tetrahedra, std::span<const Triangle> boundary)
{
    std::vector<std::uint32_t> points;
    for (const Triangle& triangle : boundary)
        points.insert(points.end(), triangle.begin(), triangle.end());
    sortUnique(points);
    const auto placeOf = [&](std::uint32_t number) -> const Eigen::Vector3d& { return positions[points[number]]; };
    const BoxTree tree(
        points.size(), [&](std::uint32_t number) { return Eigen::AlignedBox3d(placeOf(number), placeOf(number)); },
        [&](std::uint32_t number, Eigen::Index axis) { return placeOf(number)[axis]; });
    std::vector<std::atomic<std::uint8_t>> touches(points.size());
    tbb::parallel_for(std::size_t(0), tetrahedra.size(), [&](std::size_t cell) {
        const Tetrahedron& corners = tetrahedra[cell];
        const PlacedCell placed = placedCell(positions, corners);
        if (volumeSign(placed) <= 0)
            return;
        const TetrahedronPlanes planes(placed);
        const auto mayMeet = [&planes](const Eigen::AlignedBox3d& box) { return planes.mayMeet(box); };
        tree.visitNear(mayMeet, [&](std::uint32_t number) {
            if (std::ranges::find(corners, points[number]) == corners.end() && holds(placed, placeOf(number)))
                touches[number].store(1, std::memory_order_relaxed);
        });
    });
    std::vector<std::uint32_t> found;
    for (std::size_t number = 0; number < points.size(); ++number)
        if (touches[number].load(std::memory_order_relaxed) != 0)
            found.push_back(points[number]);
    return found;
}

} // namespace tetra
