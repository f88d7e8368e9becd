// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/folded_cells.h"

#include <algorithm>

namespace tetra {

namespace {

using Integers = std::array<std::int64_t, 3>;

constexpr std::uint32_t foldedCellsOfLeaf = 4;

Integers crossProductOf(const Integers& a, const Integers& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::int64_t dotProductOf(const Integers& axis, const Integers& place)
{
    return axis[0] * place[0] + axis[1] * place[1] + axis[2] * place[2];
}

/// Where a convex body lies along an axis.
struct ExtentAlongAxis {
    std::int64_t least;
    std::int64_t most;
};

/// A tetrahedron of integer corners among boxes of integer corners. Two convex polyhedra have no inner point in common
/// if a plane divides them that is parallel to a face of one, or to an edge of each: there are 25 such directions. Each
/// term of a product has one factor of each coordinate, so that none exceeds six times the grid's points.
class TetrahedronAmongBoxes {
public:
    explicit TetrahedronAmongBoxes(const FoldedCells::Corners& corners)
    {
        std::array<Integers, 4> places{};
        for (std::size_t i = 0; i < 4; ++i)
            std::ranges::copy(corners[i], places[i].begin());
        origin_ = places[0];
        for (Integers& place : places)
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] -= origin_[axis];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Integers direction{};
            direction[axis] = 1;
            add(direction, places);
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Integers& a = places[(corner + 1) % 4];
            const Integers& b = places[(corner + 2) % 4];
            const Integers& c = places[(corner + 3) % 4];
            add(crossProductOf({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]}),
                places);
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) {
                const auto& a = places[i];
                const auto& b = places[j];
                const Integers edge{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
                add({0, edge[2], -edge[1]}, places);
                add({-edge[2], 0, edge[0]}, places);
                add({edge[1], -edge[0], 0}, places);
            }
    }

    /// Whether it meets the interior of the box.
    bool meets(const FoldedCells::Place& first, const FoldedCells::Place& last) const
    {
        for (std::size_t i = 0; i < count_; ++i) {
            const ExtentAlongAxis box = extentOf(i, first, last);
            if (extents_[i].most <= box.least || box.most <= extents_[i].least)
                return false;
        }
        return true;
    }

    /// Whether it holds the box.
    bool holds(const FoldedCells::Place& first, const FoldedCells::Place& last) const
    {
        for (std::size_t face = firstFace; face < firstFace + 4; ++face) {
            const ExtentAlongAxis box = extentOf(face, first, last);
            if (box.least < extents_[face].least || box.most > extents_[face].most)
                return false;
        }
        return true;
    }

private:
    static constexpr std::size_t firstFace = 3;

    void add(const Integers& direction, const std::array<Integers, 4>& places)
    {
        if (direction == Integers{}) // the edge runs along an axis
            return;
        const auto [least, most] =
            std::ranges::minmax({dotProductOf(direction, places[0]), dotProductOf(direction, places[1]),
                                 dotProductOf(direction, places[2]), dotProductOf(direction, places[3])});
        directions_[count_] = direction;
        extents_[count_++] = {least, most};
    }

    ExtentAlongAxis extentOf(std::size_t number, const FoldedCells::Place& first, const FoldedCells::Place& last) const
    {
        const Integers& direction = directions_[number];
        ExtentAlongAxis extent{0, 0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t a = direction[axis] * (first[axis] - origin_[axis]);
            const std::int64_t b = direction[axis] * (last[axis] - origin_[axis]);
            extent.least += std::min(a, b);
            extent.most += std::max(a, b);
        }
        return extent;
    }

    Integers origin_{};
    std::array<Integers, 25> directions_{};
    std::array<ExtentAlongAxis, 25> extents_{};
    std::size_t count_ = 0;
};

} // namespace

FoldedCells::FoldedCells(std::vector<Place> cells) : cells_(std::move(cells))
{
    if (!cells_.empty())
        addNode(0, static_cast<std::uint32_t>(cells_.size()));
}

std::uint32_t FoldedCells::addNode(std::uint32_t begin, std::uint32_t end)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node node{.first = cells_[begin], .last = cells_[begin], .begin = begin, .end = end};
    for (std::uint32_t cell = begin; cell < end; ++cell)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.first[axis] = std::min(node.first[axis], cells_[cell][axis]);
            node.last[axis] = std::max(node.last[axis], cells_[cell][axis] + 1);
        }
    nodes_.push_back(node);
    if (end - begin <= foldedCellsOfLeaf)
        return number;
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (node.last[axis] - node.first[axis] > node.last[longest] - node.first[longest])
            longest = axis;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::ranges::nth_element(cells_.begin() + begin, cells_.begin() + middle, cells_.begin() + end, {},
                             [longest](const Place& cell) { return cell[longest]; });
    addNode(begin, middle);
    nodes_[number].second = addNode(middle, end);
    return number;
}

bool FoldedCells::meet(const Corners& corners) const
{
    if (cells_.empty())
        return false;
    const TetrahedronAmongBoxes tetrahedron(corners);
    // Halved at each step, so that of 2^32 cells no more than this wait.
    std::array<std::uint32_t, 40> waiting{0};
    std::size_t count = 1;
    while (count > 0) {
        const std::uint32_t number = waiting[--count];
        const Node& node = nodes_[number];
        if (!tetrahedron.meets(node.first, node.last))
            continue;
        if (tetrahedron.holds(node.first, node.last))
            return true;
        if (node.second != 0) {
            waiting[count++] = node.second;
            waiting[count++] = number + 1;
            continue;
        }
        for (std::uint32_t cell = node.begin; cell < node.end; ++cell) {
            const auto& [x, y, z] = cells_[cell];
            if (tetrahedron.meets(cells_[cell], {x + 1, y + 1, z + 1}))
                return true;
        }
    }
    return false;
}

bool isOfOneCell(const FoldedCells::Corners& corners)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [least, most] =
            std::ranges::minmax({corners[0][axis], corners[1][axis], corners[2][axis], corners[3][axis]});
        if (most - least > 1)
            return false;
    }
    return true;
}

} // namespace tetra
