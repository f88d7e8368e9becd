// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_location.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tetra::python {

namespace {

constexpr std::uint32_t mostInLeaf = 8;
constexpr double tolerance = 1e-9;

/// Six times the volume of a, b, c, d.
double volumeOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
    return (b - a).dot((c - a).cross(d - a));
}

} // namespace

Eigen::AlignedBox3d PointLocation::boxOf(std::uint32_t tetrahedron) const
{
    Eigen::AlignedBox3d box;
    for (const std::uint32_t corner : mesh_->tetrahedra[tetrahedron])
        box.extend(mesh_->positions[corner]);
    return box;
}

std::optional<PointLocation> PointLocation::of(const TetrahedralMesh& mesh, const Progress& progress)
{
    PointLocation tree(mesh);
    tree.order_.resize(mesh.tetrahedra.size());
    std::iota(tree.order_.begin(), tree.order_.end(), 0u);
    tree.nodes_.reserve(mesh.tetrahedra.size() / 2 + 1);
    // Depth first, so that a node's first half follows it; the place where the number of a second half is to be noted.
    struct Part {
        std::uint32_t first, count, parent;
    };
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<Part> waiting;
    if (!tree.order_.empty())
        waiting.push_back({0, static_cast<std::uint32_t>(tree.order_.size()), none});
    while (!waiting.empty()) {
        const auto [first, count, parent] = waiting.back();
        waiting.pop_back();
        if (count > 4096 && progress.cancelled())
            return {};
        if (parent != none)
            tree.nodes_[parent].second = static_cast<std::uint32_t>(tree.nodes_.size());
        const auto node = static_cast<std::uint32_t>(tree.nodes_.size());
        const std::uint32_t half = tree.divide(first, count);
        if (half > 0) {
            waiting.push_back({first + half, count - half, node});
            waiting.push_back({first, half, none});
        }
    }
    return tree;
}

/// Makes a node of these tetrahedra; how many of them are its first half, 0 if it is a leaf.
std::uint32_t PointLocation::divide(std::uint32_t first, std::uint32_t count)
{
    Eigen::AlignedBox3d box, middles;
    const std::span part(order_.data() + first, count);
    const auto middleOf = [this](std::uint32_t tetrahedron) -> Eigen::Vector3d {
        const auto& [a, b, c, d] = mesh_->tetrahedra[tetrahedron];
        return mesh_->positions[a] + mesh_->positions[b] + mesh_->positions[c] + mesh_->positions[d];
    };
    for (const std::uint32_t tetrahedron : part) {
        box.extend(boxOf(tetrahedron));
        middles.extend(middleOf(tetrahedron));
    }
    nodes_.push_back({box, first, count, 0});
    if (count <= mostInLeaf)
        return 0;
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const std::uint32_t half = count / 2;
    std::ranges::nth_element(part, part.begin() + half, {},
                             [&](std::uint32_t tetrahedron) { return middleOf(tetrahedron)[axis]; });
    return half;
}

std::array<double, 4> PointLocation::weightsIn(std::uint32_t tetrahedron, const Eigen::Vector3d& place) const
{
    const auto& [i, j, k, l] = mesh_->tetrahedra[tetrahedron];
    const Eigen::Vector3d &a = mesh_->positions[i], &b = mesh_->positions[j], &c = mesh_->positions[k],
                          &d = mesh_->positions[l];
    const double whole = volumeOf(a, b, c, d);
    return {volumeOf(place, b, c, d) / whole, volumeOf(a, place, c, d) / whole, volumeOf(a, b, place, d) / whole,
            volumeOf(a, b, c, place) / whole};
}

std::optional<Location> PointLocation::find(const Eigen::Vector3d& place) const
{
    std::optional<Location> found;
    double deepest = -tolerance;
    // Half of the nodes on the way down wait at most, and a tree of 2^32 tetrahedra is 30 deep.
    std::array<std::uint32_t, 64> waiting{};
    std::size_t count = 0;
    if (!nodes_.empty() && place.allFinite())
        waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t number = waiting[--count];
        const Node& node = nodes_[number];
        // Squared: a place a rounding outside the box of a tetrahedron may lie in that by its weights.
        if (const double slack = tolerance * node.box.sizes().maxCoeff();
            node.box.squaredExteriorDistance(place) > slack * slack)
            continue;
        if (node.second != 0) {
            waiting[count++] = node.second;
            waiting[count++] = number + 1;
            continue;
        }
        for (std::uint32_t next = node.first; next < node.first + node.count; ++next) {
            const auto weights = weightsIn(order_[next], place);
            const double least = std::ranges::min(weights);
            if (least > deepest) { // never for a flat tetrahedron, whose weights are no numbers
                deepest = least;
                found = {order_[next], weights};
            }
        }
    }
    return found;
}

} // namespace tetra::python
