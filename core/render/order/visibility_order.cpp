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

/// When cycles hold back what is not taken: what lies behind all of them comes last, and in order; of the rest cycles
/// are cut.
VisibilityOrder orderWithCycles(const TetrahedralMesh& mesh, const OcclusionGraph& graph, const EyePoint& eye,
                                TopologicalSort& front, TopologicalSort& back)
{
    const std::vector<std::uint32_t> held = heldByCycles(graph.cellCount(), front, back);
    VisibilityOrder order;
    order.cells.reserve(graph.cellCount());
    const auto taken = front.taken(), left = front.left();
    order.cells.insert(order.cells.end(), taken.begin(), taken.end());
    orderCycles(mesh, graph, eye, held, order);
    order.cells.insert(order.cells.end(), left.begin(), left.end());
    return order;
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
    if (!front->isComplete())
        return orderWithCycles(mesh, graph, eye, *front, *back);
    VisibilityOrder order;
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
