// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

constexpr std::uint32_t mostInLeaf = 4;

} // namespace

BoxTree::BoxTree(std::span<const Eigen::AlignedBox3d> boxes) : boxes_(boxes), items_(boxes.size())
{
    if (boxes.empty())
        return;
    std::iota(items_.begin(), items_.end(), 0);
    nodes_.emplace_back();
    build(0, 0, static_cast<std::uint32_t>(boxes.size()));
}

void BoxTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t count)
{
    Eigen::AlignedBox3d box, centres;
    for (std::uint32_t i = first; i < first + count; ++i) {
        box.extend(boxes_[items_[i]]);
        centres.extend(boxes_[items_[i]].center());
    }
    nodes_[node].box = box;
    if (count <= mostInLeaf) {
        nodes_[node].first = first;
        nodes_[node].count = count;
        return;
    }
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const std::uint32_t half = count / 2;
    const auto begin = items_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double atA = boxes_[a].center()[axis], atB = boxes_[b].center()[axis];
        return atA != atB ? atA < atB : a < b;
    });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = children;
    build(children, first, half);
    build(children + 1, first + half, count - half);
}

} // namespace tetra
