// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/order/topological_sort.h"

#include "core/base/simd.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

namespace tetra {

RelationTable::RelationTable(std::span<const CellRelation> relations, std::size_t cells, OrderEnd end)
{
    if (relations.empty())
        return;
    const auto holderAndHeld = [end](const CellRelation& relation) {
        return end == OrderEnd::Front ? std::pair(relation.front, relation.back)
                                      : std::pair(relation.back, relation.front);
    };
    first_.assign(cells + 2, 0);
    left_.assign(cells, 0);
    for (const CellRelation& relation : relations) {
        const auto [holder, held] = holderAndHeld(relation);
        ++first_[holder + 2];
        ++left_[held];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    held_.resize(relations.size());
    for (const CellRelation& relation : relations) {
        const auto [holder, held] = holderAndHeld(relation);
        held_[first_[holder + 1]++] = held;
    }
}

namespace {

/// Cells that are taken at once: while one batch is worked on, the next comes from memory.
constexpr std::size_t batchSize = 64;

/// In `facing`, the faces towards the end where taking begins have the bits from `shift` on.
TETRA_SIMD_INLINE void startStates(const std::uint8_t* facing, const std::uint8_t* inner, std::size_t count,
                                   unsigned shift, std::uint8_t* states)
{
    for (std::size_t cell = 0; cell < count; ++cell) {
        const unsigned towards = facing[cell] >> shift & inner[cell];
        const unsigned away = facing[cell] >> (4 - shift) & inner[cell];
        const unsigned pairs = towards - (towards >> 1 & 5u);
        const unsigned holders = (pairs & 3u) + (pairs >> 2);
        states[cell] = static_cast<std::uint8_t>(away | holders << 4);
    }
}

/// For each choice of faces, as bits: the chosen ones, first to last.
constexpr auto chosenFaces = [] {
    std::array<std::array<int, 4>, 16> chosen{};
    for (unsigned faces = 0; faces < 16; ++faces)
        for (unsigned face = 0, place = 0; face < 4; ++face)
            if ((faces >> face & 1u) != 0)
                chosen[faces][place++] = static_cast<int>(face);
    return chosen;
}();

/// Finds the neighbours that cells hold back, as their states say. How many; up to three places more are written.
/// Without branches, which could not be predicted.
TETRA_SIMD_INLINE std::size_t heldNeighbours(const std::uint32_t* cells, std::size_t count,
                                             const std::array<std::uint32_t, 4>* neighbours, const std::uint8_t* states,
                                             std::uint32_t* held)
{
    std::uint32_t* place = held;
    for (std::size_t i = 0; i < count; ++i) {
        const unsigned faces = states[cells[i]] & 15u;
        UInt4 row; // numbers up to 2^32, which >> must not take for negative ones
        Int4 chosen;
        std::memcpy(&row, &neighbours[cells[i]], sizeof row);
        std::memcpy(&chosen, &chosenFaces[faces], sizeof chosen);
#if defined(__clang__)
        row = __builtin_shufflevector(row, chosen) >> 2;
#else
        row = __builtin_shuffle(row, chosen) >> 2; // FaceAdjacency::cellOf()
#endif
        std::memcpy(place, &row, sizeof row);
        place += __builtin_popcount(faces);
    }
    return static_cast<std::size_t>(place - held);
}

TETRA_SIMD_INLINE bool hasStateFrom(const std::uint8_t* states, std::size_t count, std::uint8_t least,
                                    std::uint8_t beyond)
{
    const auto range = static_cast<std::uint8_t>(beyond - least);
    std::uint8_t found = 0;
    for (std::size_t cell = 0; cell < count; ++cell)
        found |= static_cast<std::uint8_t>(states[cell] - least) < range ? 1 : 0;
    return found != 0;
}

/// Calls `use` for each cell whose state is from `least` to below `beyond`, where these are few.
template <class Use>
void findStates(std::span<const std::uint8_t> states, std::uint8_t least, std::uint8_t beyond, Use&& use)
{
    constexpr std::size_t blockSize = 64;
    for (std::size_t first = 0; first < states.size(); first += blockSize) {
        const std::size_t last = std::min(first + blockSize, states.size());
        if (dispatch<hasStateFrom>(&states[first], last - first, least, beyond))
            for (std::size_t cell = first; cell < last; ++cell)
                if (states[cell] >= least && states[cell] < beyond)
                    use(static_cast<std::uint32_t>(cell));
    }
}

} // namespace

TopologicalSort::TopologicalSort(const OcclusionGraph& graph, OrderEnd end)
    : adjacency_(&graph.adjacency), relations_(graph.relations, graph.cellCount(), end), states_(graph.cellCount()),
      cells_(graph.cellCount()), end_(graph.cellCount())
{
    dispatch<startStates>(graph.facing.data(), adjacency_->innerFaces.data(), states_.size(),
                          end == OrderEnd::Front ? 0 : 4, states_.data());
    if (!relations_.isEmpty())
        for (std::uint32_t cell = 0; cell < states_.size(); ++cell)
            if (relations_.isHeld(cell))
                states_[cell] += oneHolder;
    findStates(states_, 0, oneHolder, [&](std::uint32_t cell) { cells_[free_++] = cell; });
}

void TopologicalSort::take(std::size_t most)
{
    while (taken_ < std::min(most, free_)) {
        const std::span batch = std::span(cells_).subspan(taken_, std::min({batchSize, most - taken_, free_ - taken_}));
        taken_ += batch.size();
        for (const std::uint32_t cell : std::span(cells_).subspan(taken_, std::min(batchSize, free_ - taken_)))
            __builtin_prefetch(&adjacency_->neighbours[cell]);
        releaseHeldBy(batch);
    }
}

void TopologicalSort::releaseHeldBy(std::span<const std::uint32_t> batch)
{
    std::array<std::uint32_t, 4 * batchSize + 3> held;
    const std::size_t count = dispatch<heldNeighbours>(batch.data(), batch.size(), adjacency_->neighbours.data(),
                                                       states_.data(), held.data());
    release(std::span(held).first(count));
    if (relations_.isEmpty())
        return;
    for (const std::uint32_t holder : batch)
        for (std::uint32_t cell : relations_.heldBy(holder))
            if (relations_.release(cell))
                release({&cell, 1});
}

/// Each of these cells has one holder less. Those that are free by that come to the front of `cells`; without a branch.
void TopologicalSort::release(std::span<std::uint32_t> cells)
{
    CellState* const states = states_.data(); // else read anew after each state, which could be any byte
    std::size_t freed = 0;
    for (const std::uint32_t cell : cells) {
        const auto state = static_cast<CellState>(states[cell] - oneHolder);
        states[cell] = state;
        cells[freed] = cell;
        freed += state < oneHolder ? 1 : 0;
    }
    std::ranges::copy(cells.first(freed), cells_.data() + free_);
    free_ += freed;
}

void TopologicalSort::leave(std::span<const std::uint32_t> cells)
{
    // What is free is held back for the moment, so that it may be left like the others.
    std::vector<std::uint32_t> waiting(cells_.data() + taken_, cells_.data() + free_);
    for (const std::uint32_t cell : waiting)
        states_[cell] = static_cast<CellState>((states_[cell] & facesOfState) | oneHolder);
    CellState* const states = states_.data();
    std::uint32_t* end = cells_.data() + end_;
    for (const std::uint32_t cell : cells)
        if (isHeldBack(states[cell])) {
            states[cell] |= never;
            *--end = cell;
        }
    end_ = static_cast<std::size_t>(end - cells_.data());
    std::erase_if(waiting, [&](std::uint32_t cell) { return !isHeld(cell); });
    for (const std::uint32_t cell : waiting)
        states_[cell] &= facesOfState;
    std::ranges::copy(waiting, cells_.data() + taken_);
    free_ = taken_ + waiting.size();
}

std::vector<std::uint32_t> TopologicalSort::held() const
{
    std::vector<std::uint32_t> cells;
    findStates(states_, oneHolder, beyondHeld, [&](std::uint32_t cell) { cells.push_back(cell); });
    return cells;
}

void TopologicalSort::restrictTo(std::span<const std::uint32_t> cells)
{
    std::vector<CellState> kept;
    for (const std::uint32_t cell : cells)
        kept.push_back(states_[cell]);
    for (CellState& state : states_)
        state |= never;
    for (std::size_t i = 0; i < cells.size(); ++i)
        states_[cells[i]] = kept[i];
    const auto waiting = std::span(cells_).subspan(taken_, free_ - taken_);
    free_ -= std::ranges::remove_if(waiting, [&](std::uint32_t cell) { return states_[cell] >= oneHolder; }).size();
}

std::vector<std::uint32_t> heldByCycles(std::size_t cells, TopologicalSort& front, TopologicalSort& back)
{
    const std::size_t before = back.taken().size();
    std::vector<std::uint32_t> held = front.held();
    back.restrictTo(held);
    back.take(cells);
    front.leave(back.taken().subspan(before));
    std::erase_if(held, [&](std::uint32_t cell) { return !front.isHeld(cell); });
    return held;
}

} // namespace tetra
