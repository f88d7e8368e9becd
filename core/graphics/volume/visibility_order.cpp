// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/visibility_order.h"

#include "core/graphics/volume/facing.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

namespace tetra {
namespace {

/// A cell while cells are taken.
struct CellState {
    static constexpr std::uint8_t done = 0xff;
    std::uint8_t sides; ///< bit f: the neighbour across face f is in front; bit 4 + f: it is behind
    /// How many neighbours in front are not in the order yet, one more if relations are left; or done.
    std::uint8_t hiders;
};

/// Of the two sides of a face that of the smaller cell decides, so that both agree whatever rounding did.
Buffer<CellState> neighbourSides(const FaceAdjacency& adjacency, const Buffer<std::uint8_t>& facing)
{
    Buffer<CellState> states(facing.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facing.size(), 1 << 12), [&](const auto& range) {
        for (std::size_t cell = range.begin(); cell != range.end(); ++cell) {
            unsigned bits = 0;
            for (unsigned face = 0; face < 4; ++face) {
                const std::uint32_t neighbour = adjacency.neighbours[cell][face];
                if (neighbour == FaceAdjacency::none)
                    continue;
                const std::uint32_t other = FaceAdjacency::cellOf(neighbour);
                const unsigned own = facing[cell] >> face & 0x11u;
                const unsigned theirs = facing[other] >> FaceAdjacency::faceOf(neighbour) & 0x11u;
                bits |= (cell < other ? own : (theirs >> 4 | (theirs & 1u) << 4)) << face;
            }
            states[cell] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(std::popcount(bits & 15u))};
        }
    });
    return states;
}

/// The relations' backs by their fronts.
struct RelationTable {
    std::vector<std::uint32_t> first; ///< for each cell, and after the last the end; empty without relations
    std::vector<std::uint32_t> backs;

    RelationTable(std::span<const CellRelation> relations, std::size_t cells)
    {
        if (relations.empty())
            return;
        first.assign(cells + 2, 0);
        for (const CellRelation& relation : relations)
            ++first[relation.front + 2];
        std::partial_sum(first.begin(), first.end(), first.begin());
        backs.resize(relations.size());
        for (const CellRelation& relation : relations)
            backs[first[relation.front + 1]++] = relation.back;
    }
    std::span<const std::uint32_t> backsOf(std::uint32_t cell) const
    {
        if (first.empty())
            return {};
        return std::span(backs).subspan(first[cell], first[cell + 1] - first[cell]);
    }
};

/// Takes cells that nothing unordered hides, depth first, so that what is drawn together lies together.
class Sorter {
public:
    Sorter(const FaceAdjacency& adjacency, Buffer<CellState> cells, std::span<const CellRelation> relations)
        : adjacency_(adjacency), table_(relations, cells.size()), cells_(std::move(cells)), stack_(cells_.size())
    {
        if (!relations.empty())
            relationsLeft_.assign(cells_.size(), 0);
        for (const CellRelation& relation : relations)
            if (relationsLeft_[relation.back]++ == 0)
                ++cells_[relation.back].hiders;
        for (std::size_t cell = cells_.size(); cell-- > 0;)
            if (cells_[cell].hiders == 0)
                stack_[waiting_++] = static_cast<std::uint32_t>(cell);
        order_.cells.resize(cells_.size());
    }

    VisibilityOrder sorted(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                           std::span<const ProjectedVertex> vertices)
    {
        takeFree();
        if (taken_ < order_.cells.size())
            breakCycles(tetrahedra, vertices);
        return std::move(order_);
    }

private:
    static constexpr std::uint8_t done = CellState::done;

    void takeFree()
    {
        while (waiting_ > 0) {
            const std::uint32_t cell = stack_[--waiting_];
            order_.cells[taken_++] = cell;
            const auto& neighbours = adjacency_.neighbours[cell];
            const unsigned sides = cells_[cell].sides;
            cells_[cell].hiders = done;
            for (std::size_t face = 0; face < 4; ++face)
                if ((sides >> face & 16u) != 0)
                    release(FaceAdjacency::cellOf(neighbours[face]));
            for (const std::uint32_t back : table_.backsOf(cell))
                if (--relationsLeft_[back] == 0)
                    release(back);
        }
    }

    void release(std::uint32_t cell)
    {
        CellState& state = cells_[cell];
        if (state.hiders != done && --state.hiders == 0) {
            stack_[waiting_++] = cell;
            __builtin_prefetch(&adjacency_.neighbours[cell]);
        }
    }

    void breakCycles(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                     std::span<const ProjectedVertex> vertices)
    {
        std::vector<std::pair<float, std::uint32_t>> left;
        for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
            if (cells_[cell].hiders != done) {
                float depth = 0;
                for (const std::uint32_t vertex : tetrahedra[cell])
                    depth += vertices[vertex].w;
                left.emplace_back(std::isnan(depth) ? 0 : depth, cell);
            }
        std::ranges::sort(left);
        for (const auto& [depth, cell] : left)
            if (cells_[cell].hiders != done) {
                ++order_.brokenCycles;
                stack_[waiting_++] = cell;
                takeFree();
            }
    }

    const FaceAdjacency& adjacency_;
    RelationTable table_;
    Buffer<CellState> cells_;
    std::vector<std::uint32_t> relationsLeft_; ///< for each cell, how many of its relations' fronts are not taken yet
    Buffer<std::uint32_t> stack_;
    std::size_t waiting_ = 0; ///< on the stack
    std::size_t taken_ = 0;
    VisibilityOrder order_;
};

} // namespace

VisibilityOrder orderByAdjacency(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                 const FaceAdjacency& adjacency, std::span<const ProjectedVertex> vertices,
                                 bool perspective, std::span<const CellRelation> relations)
{
    const Buffer<std::uint8_t> facing = faceFacing(tetrahedra, vertices, perspective);
    return Sorter(adjacency, neighbourSides(adjacency, facing), relations).sorted(tetrahedra, vertices);
}

} // namespace tetra
