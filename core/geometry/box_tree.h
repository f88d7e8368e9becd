// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Boxes in a balanced binary tree. O(n log n) to build, 60 bytes a box.
class BoxTree {
public:
    explicit BoxTree(std::span<const Eigen::AlignedBox3d> boxes);

    /// Calls visit(item) for the boxes that `meets` says yes of; it must say yes of a box around one it says yes of.
    template <class Meets, class Visit> void forEach(Meets&& meets, Visit&& visit) const
    {
        if (nodes_.empty())
            return;
        std::vector<std::uint32_t> open{0};
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (!meets(node.box))
                continue;
            if (node.count > 0) {
                for (std::uint32_t i = 0; i < node.count; ++i)
                    if (meets(boxes_[items_[node.first + i]]))
                        visit(items_[node.first + i]);
            } else {
                open.push_back(node.first);
                open.push_back(node.first + 1);
            }
        }
    }

private:
    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t first = 0; ///< of its items, or of its two children
        std::uint32_t count = 0; ///< of items; 0 for an inner node
    };
    void build(std::uint32_t node, std::uint32_t first, std::uint32_t count);

    std::span<const Eigen::AlignedBox3d> boxes_;
    std::vector<std::uint32_t> items_;
    std::vector<Node> nodes_;
};

} // namespace tetra
