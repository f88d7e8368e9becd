// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/triangle_tree.h"

#include <algorithm>
#include <numeric>

namespace tetra {

TriangleTree::TriangleTree(std::span<const Eigen::Vector3d> positions, std::span<const PointTriangle> triangles)
    : positions_(positions), triangles_(triangles), order_(triangles.size())
{
    std::iota(order_.begin(), order_.end(), 0);
    if (!triangles.empty())
        build(0, 0, static_cast<std::uint32_t>(triangles.size()));
}

Eigen::AlignedBox3d TriangleTree::boxOf(std::uint32_t triangle) const
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : corners(triangle))
        box.extend(corner);
    return box;
}

void TriangleTree::build(std::size_t node, std::uint32_t first, std::uint32_t end)
{
    if (boxes_.size() <= node)
        boxes_.resize(node + 1);
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = first; i < end; ++i)
        box.extend(boxOf(order_[i]));
    boxes_[node] = box;
    if (end - first <= leafSize)
        return;
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto sum = [&](std::uint32_t triangle) {
        const PointTriangle& t = triangles_[triangle];
        return positions_[t[0]][axis] + positions_[t[1]][axis] + positions_[t[2]][axis];
    };
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return sum(a) < sum(b); });
    build(2 * node + 1, first, middle);
    build(2 * node + 2, middle, end);
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& from) const
{
    Nearest best;
    if (!triangles_.empty())
        findNearest(0, 0, static_cast<std::uint32_t>(triangles_.size()), from, best);
    return best;
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& from, std::uint32_t hint) const
{
    Nearest best{hint, nearestPlace(corners(hint), from)};
    findNearest(0, 0, static_cast<std::uint32_t>(triangles_.size()), from, best);
    return best;
}

void TriangleTree::findNearest(std::size_t node, std::uint32_t first, std::uint32_t end, const Eigen::Vector3d& from,
                               Nearest& best) const
{
    if (end - first <= leafSize) {
        for (std::uint32_t i = first; i < end; ++i)
            if (const TrianglePlace place = nearestPlace(corners(order_[i]), from);
                place.distance < best.place.distance)
                best = {order_[i], place};
        return;
    }
    const std::uint32_t middle = first + (end - first) / 2;
    const auto visit = [&](std::size_t child, double distance, std::uint32_t from_, std::uint32_t to) {
        if (distance < best.place.distance)
            findNearest(child, from_, to, from, best);
    };
    const std::size_t left = 2 * node + 1, right = 2 * node + 2;
    const double toLeft = boxes_[left].exteriorDistance(from), toRight = boxes_[right].exteriorDistance(from);
    if (toLeft <= toRight)
        visit(left, toLeft, first, middle);
    visit(right, toRight, middle, end);
    if (toLeft > toRight)
        visit(left, toLeft, first, middle);
}

} // namespace tetra
