// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/visibility_order.h"

#include "core/base/simd.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

namespace tetra {
namespace {

/// A cell while cells are taken: bit f: the neighbour across face f is behind it; from bit 4 on: how many neighbours in
/// front are not in the order yet, one more if relations are left. At most five, and what is in the order is counted
/// down no more than that: from 0 it wraps around and does not come to 0 again.
using CellState = std::uint8_t;
constexpr unsigned oneHider = 16;
constexpr CellState mostHidden = 6 * oneHider;
constexpr CellState takenHidden = 15 * oneHider;

TETRA_SIMD_CLONES void combine(const std::uint8_t* facing, const std::uint8_t* inner, std::size_t count,
                               CellState* states)
{
    for (std::size_t cell = 0; cell < count; ++cell) {
        const unsigned front = facing[cell] & inner[cell];
        const unsigned pairs = front - (front >> 1 & 5u);
        const unsigned hiders = (pairs & 3u) + (pairs >> 2);
        states[cell] = static_cast<CellState>((facing[cell] >> 4 & inner[cell]) | hiders * oneHider);
    }
}

/// One state more than there are cells, for what is not there.
Buffer<CellState> startStates(const FaceAdjacency& adjacency, const Buffer<std::uint8_t>& facing)
{
    Buffer<CellState> states(facing.size() + 1);
    states.back() = takenHidden;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facing.size(), 1 << 12), [&](const auto& range) {
        const std::size_t first = range.begin();
        combine(&facing[first], &adjacency.innerFaces[first], range.size(), &states[first]);
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
    Sorter(const FaceAdjacency& adjacency, Buffer<CellState> states, std::span<const CellRelation> relations)
        : adjacency_(adjacency), count_(states.size() - 1), table_(relations, count_), states_(std::move(states)),
          cells_(count_ + 1)
    {
        if (!relations.empty())
            relationsLeft_.assign(count_, 0);
        for (const CellRelation& relation : relations)
            if (relationsLeft_[relation.back]++ == 0)
                states_[relation.back] += oneHider;
        findFree();
    }

    VisibilityOrder sorted(const TetrahedralMesh& mesh, const EyePoint& eye)
    {
        takeFree();
        if (taken_ < count_)
            breakCycles(mesh, eye);
        cells_.resize(count_);
        order_.cells = std::move(cells_);
        return std::move(order_);
    }

private:
    /// Cells that are taken at once: while one waits for memory, others go on.
    static constexpr std::size_t batchSize = 64;

    /// What nothing hides at first: few cells, looked for eight at a time.
    void findFree()
    {
        constexpr std::uint64_t ones = 0x0101010101010101;
        std::size_t cell = count_;
        while (cell > 0) {
            if (std::uint64_t eight = 0; cell % 8 == 0) {
                std::memcpy(&eight, &states_[cell - 8], sizeof eight);
                const std::uint64_t hiders = eight >> 4 & 15 * ones;
                if (((hiders + 15 * ones) & 16 * ones) == 16 * ones) {
                    cell -= 8;
                    continue;
                }
            }
            if (states_[--cell] < oneHider)
                cells_[count_ - waiting_++] = static_cast<std::uint32_t>(cell);
        }
    }

    void takeFree()
    {
        while (waiting_ > 0) {
            const std::size_t size = std::min(waiting_, batchSize);
            waiting_ -= size;
            const std::span batch = std::span(cells_).subspan(taken_, size);
            std::ranges::copy(std::span(cells_).subspan(count_ + 1 - waiting_ - size, size), batch.begin());
            taken_ += size;
            for (const std::uint32_t cell : batch)
                __builtin_prefetch(&adjacency_.neighbours[cell]);
            for (const std::uint32_t cell : batch) {
                releaseNeighbours(cell);
                for (const std::uint32_t back : table_.backsOf(cell))
                    if (--relationsLeft_[back] == 0)
                        release(back, 1);
            }
        }
    }

    void releaseNeighbours(std::uint32_t cell)
    {
        const auto& neighbours = adjacency_.neighbours[cell];
        const unsigned state = states_[cell];
        for (std::size_t face = 0; face < 4; ++face)
            release(std::min(FaceAdjacency::cellOf(neighbours[face]), static_cast<std::uint32_t>(count_)),
                    state >> face & 1u);
    }

    /// Without a branch, which could not be predicted: with `times` 0 nothing changes.
    void release(std::uint32_t cell, unsigned times)
    {
        const auto state = static_cast<CellState>(states_[cell] - times * oneHider);
        states_[cell] = state;
        cells_[count_ - waiting_] = cell;
        waiting_ += times & (state < oneHider ? 1u : 0u);
    }

    void breakCycles(const TetrahedralMesh& mesh, const EyePoint& eye)
    {
        std::vector<std::pair<double, std::uint32_t>> left;
        for (std::uint32_t cell = 0; cell < count_; ++cell)
            if (isHidden(cell)) {
                const double distance = distanceOf(mesh, cell, eye);
                left.emplace_back(std::isnan(distance) ? 0 : distance, cell);
            }
        std::ranges::sort(left);
        for (const auto& [distance, cell] : left)
            if (isHidden(cell)) {
                ++order_.brokenCycles;
                states_[cell] |= takenHidden;
                cells_[count_ - waiting_++] = cell;
                takeFree();
            }
    }

    bool isHidden(std::uint32_t cell) const { return states_[cell] >= oneHider && states_[cell] < mostHidden; }

    /// The distance of the cell's centre, squared; in orthographic views along the view.
    static double distanceOf(const TetrahedralMesh& mesh, std::uint32_t cell, const EyePoint& eye)
    {
        Eigen::Vector3d centre(0, 0, 0);
        for (const std::uint32_t vertex : mesh.tetrahedra[cell])
            centre += mesh.positions[vertex].cast<double>() / 4;
        return eye.perspective ? (centre - eye.place).squaredNorm() : -centre.dot(eye.place);
    }

    const FaceAdjacency& adjacency_;
    std::size_t count_;
    RelationTable table_;
    Buffer<CellState> states_;
    std::vector<std::uint32_t> relationsLeft_; ///< for each cell, how many of its relations' fronts are not taken yet
    /// At the front the cells that are taken, at the end those that wait, the last one first, and always one place
    /// between.
    Buffer<std::uint32_t> cells_;
    std::size_t waiting_ = 0;
    std::size_t taken_ = 0;
    VisibilityOrder order_;
};

} // namespace

VisibilityOrder orderByAdjacency(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency, const EyePoint& eye,
                                 std::span<const CellRelation> relations)
{
    return Sorter(adjacency, startStates(adjacency, faceFacing(mesh, eye)), relations).sorted(mesh, eye);
}

} // namespace tetra
