// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/error_queue.h"

#include <algorithm>

namespace tetra {

void ErrorQueue::start(float largestError)
{
    classes_.resize(classCount);
    for (std::vector<Waiting>& waiting : classes_)
        waiting.clear();
    sorted_.clear();
    heap_.clear();
    entryCount_ = 0;
    foremost_ = classCount - 1;
    const std::uint32_t largest = std::bit_cast<std::uint32_t>(largestError) >> classShift;
    firstClass_ = largest < classCount ? 0 : largest - classCount + 1;
}

bool ErrorQueue::current(const Candidate& candidate, std::span<const PointBucket> buckets) const
{
    const PointBucket& bucket = buckets[candidate.bucket];
    return bucket.count > 0 && this->candidate(candidate.bucket, bucket).key == candidate.key;
}

std::uint32_t ErrorQueue::top(std::span<const PointBucket> buckets)
{
    do {
        while (!sorted_.empty() && !current(sorted_.back(), buckets)) {
            sorted_.pop_back();
            --entryCount_;
        }
        while (!heap_.empty() && !current(heap_.front(), buckets)) {
            std::pop_heap(heap_.begin(), heap_.end());
            heap_.pop_back();
            --entryCount_;
        }
        if (!sorted_.empty() && (heap_.empty() || heap_.front() < sorted_.back()))
            return sorted_.back().bucket;
        if (!heap_.empty())
            return heap_.front().bucket;
    } while (openNextClass(buckets));
    return none;
}

bool ErrorQueue::openNextClass(std::span<const PointBucket> buckets)
{
    while (foremost_ > 0 && classes_[foremost_].empty())
        --foremost_;
    std::vector<Waiting>& waiting = classes_[foremost_];
    if (waiting.empty())
        return false;
    for (const Waiting& entry : waiting)
        if (buckets[entry.bucket].count > 0 && buckets[entry.bucket].error == entry.error)
            sorted_.push_back(candidate(entry.bucket, buckets[entry.bucket]));
        else
            --entryCount_;
    // Most classes are small and come again with the next box; the room of a large one is given back.
    constexpr std::size_t roomWorthKeeping = 64;
    if (waiting.capacity() > roomWorthKeeping)
        std::vector<Waiting>().swap(waiting);
    else
        waiting.clear();
    std::sort(sorted_.begin(), sorted_.end());
    return true;
}

void ErrorQueue::sweep(std::span<const PointBucket> buckets)
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
