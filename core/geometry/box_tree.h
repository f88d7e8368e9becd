// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tetra {

/// Items with boxes, halved again and again along the longest side of what they fill: a balanced binary tree, to find
/// those near a place or a shape. O(n log^2 n) to build, 4 bytes an item and 24 more for its share of the boxes. Knows
/// items by their numbers; asking is safe from any number of threads.
class BoxTree {
public:
    BoxTree() = default;
    /// Of the items before `count`. `boxOf(item)` is an item's box, `along(item, axis)` where it lies on an axis, such
    /// as the middle of the box: of equal ones any comes first.
    template <class BoxOf, class Along> BoxTree(std::size_t count, const BoxOf& boxOf, const Along& along)
        : order_(count)
    {
        std::iota(order_.begin(), order_.end(), 0);
        if (count > 0)
            build({0, 0, static_cast<std::uint32_t>(count)}, boxOf, along);
    }

    /// Calls visit(item) for all items that lie in a box which `meets` says yes of, and for some more near them.
    template <class Meets, class Visit> void visitNear(const Meets& meets, const Visit& visit) const
    {
        if (!order_.empty())
            descend({0, 0, size()}, meets, visit);
    }

    /// Calls visit(item) for items that may be nearer to the place than bound(), which visit() may lower; near ones
    /// come first.
    template <class Bound, class Visit>
    void visitNearer(const Eigen::Vector3d& place, const Bound& bound, const Visit& visit) const
    {
        if (!order_.empty())
            approach({0, 0, size()}, place, bound, visit);
    }

private:
    static constexpr std::uint32_t leafSize = 4;

    /// The node `number` holds order_[first, end). Its children are the nodes 2 number + 1 and + 2, a half each.
    struct Node {
        std::size_t number;
        std::uint32_t first;
        std::uint32_t end;

        bool isLeaf() const { return end - first <= leafSize; }
        std::uint32_t middle() const { return first + (end - first) / 2; }
        Node left() const { return {2 * number + 1, first, middle()}; }
        Node right() const { return {2 * number + 2, middle(), end}; }
    };

    std::uint32_t size() const { return static_cast<std::uint32_t>(order_.size()); }

    template <class BoxOf, class Along> void build(const Node& node, const BoxOf& boxOf, const Along& along)
    {
        Eigen::AlignedBox3d box;
        for (std::uint32_t i = node.first; i < node.end; ++i)
            box.extend(boxOf(order_[i]));
        if (boxes_.size() <= node.number)
            boxes_.resize(node.number + 1);
        boxes_[node.number] = box;
        if (node.isLeaf())
            return;
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        const auto begin = order_.begin();
        std::nth_element(begin + node.first, begin + node.middle(), begin + node.end,
                         [&](std::uint32_t a, std::uint32_t b) { return along(a, axis) < along(b, axis); });
        build(node.left(), boxOf, along);
        build(node.right(), boxOf, along);
    }

    template <class Meets, class Visit> void descend(const Node& node, const Meets& meets, const Visit& visit) const
    {
        if (!meets(boxes_[node.number]))
            return;
        if (node.isLeaf()) {
            for (std::uint32_t i = node.first; i < node.end; ++i)
                visit(order_[i]);
            return;
        }
        descend(node.left(), meets, visit);
        descend(node.right(), meets, visit);
    }

    template <class Bound, class Visit>
    void approach(const Node& node, const Eigen::Vector3d& place, const Bound& bound, const Visit& visit) const
    {
        if (node.isLeaf()) {
            for (std::uint32_t i = node.first; i < node.end; ++i)
                visit(order_[i]);
            return;
        }
        Node nearer = node.left(), farther = node.right();
        double toNearer = boxes_[nearer.number].exteriorDistance(place);
        double toFarther = boxes_[farther.number].exteriorDistance(place);
        if (toFarther < toNearer) {
            std::swap(nearer, farther);
            std::swap(toNearer, toFarther);
        }
        if (toNearer < bound())
            approach(nearer, place, bound, visit);
        if (toFarther < bound())
            approach(farther, place, bound, visit);
    }

    std::vector<std::uint32_t> order_;
    std::vector<Eigen::AlignedBox3d> boxes_;
};

} // namespace tetra
