// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/cell_relations.h"

#include <numeric>
#include <utility>

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

} // namespace tetra
