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

CollapseQueue::Entry CollapseQueue::pop()
{
    if (sorted_.empty() && late_.empty())
        openNextClass();
    --size_;
    if (late_.empty() || (!sorted_.empty() && late_.front().comesAfter(sorted_.back()))) {
        const Entry first = sorted_.back();
        sorted_.pop_back();
        return first;
    }
    std::ranges::pop_heap(late_, comesAfter);
    const Entry first = late_.back();
    late_.pop_back();
    return first;
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
