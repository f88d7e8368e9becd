// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/order/visibility_order.h"

#include "core/render/order/topological_sort.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace tetra {

namespace {

/// The distance of a cell's centre, squared; in orthographic views along the view. 0 if it is no number.
double distanceOf(const TetrahedralMesh& mesh, std::uint32_t cell, const EyePoint& eye)
{
    Eigen::Vector3d centre(0, 0, 0);
    for (const std::uint32_t vertex : mesh.tetrahedra[cell])
        centre += mesh.positions[vertex].cast<double>() / 4;
    const double distance = eye.perspective ? (centre - eye.place).squaredNorm() : -centre.dot(eye.place);
    return std::isnan(distance) ? 0 : distance;
}

/// When cycles hold back what is not taken: what lies behind all of them comes last, and in order; of the rest the
/// nearest cell is taken each time that none is free. How often that was.
std::size_t breakCycles(const TetrahedralMesh& mesh, const EyePoint& eye, TopologicalSort& front, TopologicalSort& back)
{
    const std::size_t all = mesh.tetrahedra.size();
    const std::size_t before = back.taken().size();
    const std::vector<std::uint32_t> held = front.held();
    back.restrictTo(held);
    back.take(all);
    front.leave(back.taken().subspan(before));
    std::vector<std::pair<double, std::uint32_t>> nearest;
    for (const std::uint32_t cell : held)
        if (front.isHeld(cell))
            nearest.emplace_back(distanceOf(mesh, cell, eye), cell);
    std::ranges::sort(nearest);
    std::size_t broken = 0;
    for (const auto& [distance, cell] : nearest)
        if (front.isHeld(cell)) {
            ++broken;
            front.free(cell);
            front.take(all);
        }
    return broken;
}

} // namespace

VisibilityOrder orderByAdjacency(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency, const EyePoint& eye,
                                 std::span<const CellRelation> relations)
{
    const Buffer<std::uint8_t> facing = classifyFaces(mesh, eye);
    const OcclusionGraph graph{adjacency, facing, relations};
    const std::size_t all = graph.cellCount();
    std::optional<TopologicalSort> front, back;
    const auto takeFrom = [&graph](OrderEnd end, std::optional<TopologicalSort>& cells, std::size_t most) {
        cells.emplace(graph, end);
        cells->take(most);
    };
    // One half each, on one thread as well: pictures must not depend on how many threads there are or which is faster.
    tbb::parallel_invoke([&] { takeFrom(OrderEnd::Front, front, all - all / 2); },
                         [&] { takeFrom(OrderEnd::Back, back, all / 2); });
    // What is taken from the back hides only what is taken from there as well: it may come last, but for what both
    // took.
    front->leave(back->taken());
    front->take(all);
    VisibilityOrder order;
    if (!front->isComplete())
        order.brokenCycles = breakCycles(mesh, eye, *front, *back);
    order.cells = std::move(*front).order();
    return order;
}

namespace {

using Eigen::Vector3d;

double degreesBetween(const Vector3d& a, const Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

Vector3d towardsEye(const Camera& camera)
{
    return viewMatrix(camera).block<1, 3>(2, 0).transpose();
}

} // namespace

double orderDrift(const Eigen::AlignedBox3d& bounds, const Camera& from, const Camera& to)
{
    if (from.perspective != to.perspective)
        return 180;
    if (!from.perspective)
        return degreesBetween(towardsEye(from), towardsEye(to));
    const Vector3d before = eyePosition(from), after = eyePosition(to);
    if (bounds.isEmpty() || before == after)
        return 0;
    if (bounds.contains(before) || bounds.contains(after))
        return 180;
    double drift = degreesBetween(before - bounds.center(), after - bounds.center());
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3d place = bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        drift = std::max(drift, degreesBetween(before - place, after - place));
    }
    return drift;
}

} // namespace tetra
