// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace tetra {

/// A binary tree of boxes, to find those at or near a place. O(n log n) to make.
class BoxTree {
public:
    explicit BoxTree(std::vector<Eigen::AlignedBox3d> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
    {
        std::iota(order_.begin(), order_.end(), 0u);
        if (!order_.empty())
            make(0, static_cast<std::uint32_t>(order_.size()));
    }

    /// Calls `visit` with the number of each box that contains the point.
    template <class Visit> void visitAt(const Eigen::Vector3d& point, Visit&& visit) const
    {
        if (!nodes_.empty())
            visitAt(0, point, visit);
    }

    /// Of the least squared distance that `distanceOf` gives for the thing in a box, which is no less than the box's.
    template <class DistanceOf> std::uint32_t nearest(const Eigen::Vector3d& point, DistanceOf&& distanceOf) const
    {
        Found found;
        if (!nodes_.empty())
            searchNearest(0, point, distanceOf, found);
        return found.number;
    }

private:
    static constexpr std::uint32_t leafSize = 4;

    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t first = 0, last = 0; ///< of the order
        std::uint32_t second = 0;          ///< child; the other one follows the node; 0: a leaf
    };
    struct Found {
        double distance = std::numeric_limits<double>::infinity();
        std::uint32_t number = 0;
    };

    std::uint32_t make(std::uint32_t first, std::uint32_t last)
    {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        Node node{.box = {}, .first = first, .last = last};
        for (std::uint32_t i = first; i < last; ++i)
            node.box.extend(boxes_[order_[i]]);
        nodes_.push_back(node);
        if (last - first <= leafSize)
            return number;
        Eigen::Index axis = 0;
        node.box.sizes().maxCoeff(&axis);
        const std::uint32_t middle = first + (last - first) / 2;
        std::nth_element(
            order_.begin() + first, order_.begin() + middle, order_.begin() + last,
            [&](std::uint32_t a, std::uint32_t b) { return boxes_[a].center()[axis] < boxes_[b].center()[axis]; });
        make(first, middle);
        const std::uint32_t second = make(middle, last);
        nodes_[number].second = second;
        return number;
    }

    template <class Visit> void visitAt(std::uint32_t number, const Eigen::Vector3d& point, Visit& visit) const
    {
        const Node& node = nodes_[number];
        if (!node.box.contains(point))
            return;
        if (node.second != 0) {
            visitAt(number + 1, point, visit);
            visitAt(node.second, point, visit);
            return;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i)
            if (boxes_[order_[i]].contains(point))
                visit(order_[i]);
    }

    template <class DistanceOf>
    void searchNearest(std::uint32_t number, const Eigen::Vector3d& point, DistanceOf& distanceOf, Found& found) const
    {
        const Node& node = nodes_[number];
        if (node.box.squaredExteriorDistance(point) >= found.distance)
            return;
        if (node.second == 0) {
            for (std::uint32_t i = node.first; i < node.last; ++i)
                if (const double distance = distanceOf(order_[i]); distance < found.distance)
                    found = {distance, order_[i]};
            return;
        }
        std::uint32_t near = number + 1, far = node.second;
        if (nodes_[far].box.squaredExteriorDistance(point) < nodes_[near].box.squaredExteriorDistance(point))
            std::swap(near, far);
        searchNearest(near, point, distanceOf, found);
        searchNearest(far, point, distanceOf, found);
    }

    std::vector<Eigen::AlignedBox3d> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace tetra
