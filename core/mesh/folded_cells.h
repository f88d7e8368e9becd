// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A set of cells of a grid, in computational space, that says which tetrahedra meet them. Immutable. Made for the
/// folded cells of a curvilinear grid (FORMAT.md), of which most grids have none and some thousands.
class FoldedCells {
public:
    using Place = std::array<std::int32_t, 3>;
    using Corners = std::array<Place, 4>;

    FoldedCells() = default;
    /// `cells`: the first corner of each, distinct. O(n log n).
    explicit FoldedCells(std::vector<Place> cells);

    std::size_t count() const noexcept { return cells_.size(); }

    /// Whether the tetrahedron meets the interior of one of the cells. Its corners are points of the grid and in no
    /// plane. Exact where the grid has at most 2^32 points; O(log n) unless many cells lie around the tetrahedron that
    /// it misses.
    bool meet(const Corners& corners) const;

private:
    /// The cells [begin, end) in the box from `first` to `last`, in corners of cells. The nodes of its first half
    /// follow; those of its second begin at `second`, or there are none.
    struct Node {
        Place first{};
        Place last{};
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t second = 0;
    };

    std::uint32_t addNode(std::uint32_t begin, std::uint32_t end);

    std::vector<Place> cells_;
    std::vector<Node> nodes_;
};

/// Whether four points of a grid are corners of one of its cells. Exactly the tetrahedra whose circumsphere has no
/// point of the grid strictly inside are so: no further point can destroy them in a Delaunay mesh.
bool isOfOneCell(const FoldedCells::Corners& corners);

} // namespace tetra
