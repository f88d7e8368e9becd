// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/error_queue.h"

#include <algorithm>

namespace tetra {

void ErrorQueue::pushHeap(const Candidate& candidate)
{
    heap_.push_back(candidate);
    std::push_heap(heap_.begin(), heap_.end());
}

void ErrorQueue::moveForemost(std::uint32_t entryClass)
{
    std::vector<Waiting>& waiting = classes_[foremost_];
    for (const Candidate& candidate : heap_)
        waiting.push_back({candidate.bucket, candidate.error});
    heap_.clear();
    foremost_ = entryClass;
}

bool ErrorQueue::current(const Candidate& candidate, const std::vector<PointBucket>& buckets) const
{
    const PointBucket& bucket = buckets[candidate.bucket];
    return bucket.count > 0 && bucket.error == candidate.error && lattice_->index(bucket.worst) == candidate.rank;
}

std::uint32_t ErrorQueue::top(const std::vector<PointBucket>& buckets)
{
    for (;;) {
        while (!heap_.empty()) {
            if (current(heap_.front(), buckets))
                return heap_.front().bucket;
            std::pop_heap(heap_.begin(), heap_.end());
            heap_.pop_back();
            --entryCount_;
        }
        while (foremost_ > 0 && classes_[foremost_].empty())
            --foremost_;
        std::vector<Waiting>& waiting = classes_[foremost_];
        if (waiting.empty())
            return none;
        for (const Waiting& entry : waiting)
            if (buckets[entry.bucket].count > 0 && buckets[entry.bucket].error == entry.error)
                heap_.push_back({entry.error, lattice_->index(buckets[entry.bucket].worst), entry.bucket});
            else
                --entryCount_;
        std::vector<Waiting>().swap(waiting);
        std::make_heap(heap_.begin(), heap_.end());
    }
}

void ErrorQueue::sweep(const std::vector<PointBucket>& buckets)
{
    for (std::vector<Waiting>& waiting : classes_) {
        const std::size_t before = waiting.size();
        std::erase_if(waiting, [&](const Waiting& entry) {
            return buckets[entry.bucket].count == 0 || buckets[entry.bucket].error != entry.error;
        });
        entryCount_ -= before - waiting.size();
        if (waiting.capacity() > 2 * waiting.size() + 16)
            waiting.shrink_to_fit();
    }
}

} // namespace tetra
