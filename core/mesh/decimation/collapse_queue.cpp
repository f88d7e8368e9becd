// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/collapse_queue.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace tetra {

namespace {

bool comesAfter(const CollapseQueue::Entry& one, const CollapseQueue::Entry& other)
{
    return one.comesAfter(other);
}

} // namespace

std::size_t CollapseQueue::classOf(float key)
{
    return std::bit_cast<std::uint32_t>(key) >> classBits & (classCount - 1);
}

void CollapseQueue::push(const Entry& entry)
{
    ++size_;
    const std::size_t own = classOf(entry.key);
    if (own > open_) {
        classes_[own].push_back(entry);
        return;
    }
    late_.push_back(entry);
    std::ranges::push_heap(late_, comesAfter);
}

float CollapseQueue::leastKey()
{
    if (sorted_.empty() && late_.empty())
        openNextClass();
    return lateIsFirst() ? late_.front().key : sorted_.back().key;
}

CollapseQueue::Entry CollapseQueue::pop()
{
    if (sorted_.empty() && late_.empty())
        openNextClass();
    --size_;
    std::vector<Entry>& from = lateIsFirst() ? late_ : sorted_;
    if (&from == &late_)
        std::ranges::pop_heap(late_, comesAfter);
    const Entry first = from.back();
    from.pop_back();
    return first;
}

/// One of the two is not empty.
bool CollapseQueue::lateIsFirst() const
{
    return sorted_.empty() || (!late_.empty() && sorted_.back().comesAfter(late_.front()));
}

void CollapseQueue::openNextClass()
{
    while (classes_[open_].empty())
        ++open_;
    sorted_ = std::move(classes_[open_]);
    classes_[open_] = {};
    std::ranges::sort(sorted_, comesAfter);
}

} // namespace tetra
