// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <tan/base.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// What one check found wrong: the texts of the first few places, and how many there are in all. Says the same however
/// many threads looked. All members may be called from any thread.
class Findings {
public:
    /// `place` orders the findings; `describe` gives the sentence and is only called for those that are kept.
    template <class Describe> void add(std::uint64_t place, Describe&& describe)
    {
        const std::lock_guard lock(mutex_);
        ++count_;
        if (texts_.size() == mostTexts && place > std::prev(texts_.end())->first)
            return;
        texts_.emplace(place, describe());
        if (texts_.size() > mostTexts)
            texts_.erase(std::prev(texts_.end()));
    }

    std::uint64_t count() const
    {
        const std::lock_guard lock(mutex_);
        return count_;
    }
    bool none() const { return count() == 0; }

    /// Appends the texts, and how many more there are.
    void moveTo(std::vector<std::string>& failures)
    {
        const std::lock_guard lock(mutex_);
        const std::uint64_t more = count_ - texts_.size();
        for (const auto& [place, text] : texts_)
            failures.push_back(text);
        if (more > 0)
            failures.push_back("... and " + std::to_string(more) + " more of this kind.");
        texts_.clear();
    }

private:
    static constexpr std::size_t mostTexts = 3;

    mutable std::mutex mutex_;
    std::uint64_t count_ = 0;
    std::multiset<std::pair<std::uint64_t, std::string>> texts_; ///< of one place in the order of the alphabet
};

/// The largest of the numbers that threads find, none of which is negative.
class Largest {
public:
    void add(double number)
    {
        double& known = ofThreads_.local();
        known = std::max(known, number);
    }
    double ofAll() const
    {
        return std::accumulate(ofThreads_.begin(), ofThreads_.end(), 0.0,
                               [](double a, double b) { return std::max(a, b); });
    }

private:
    tbb::enumerable_thread_specific<double> ofThreads_{0.0};
};

/// Calls check(number) for every number below `count`, on all threads of the current arena, `atOnce` of them in a row.
/// The progress reads `activity`. An Error only if it was cancelled; then nothing further is begun.
template <class Check> Status verifyEach(std::size_t count, std::size_t atOnce, const Message& activity,
                                         const Progress& progress, const Check& check)
{
    SharedProgress shared(progress, count, activity);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, atOnce), [&](const auto& range) {
        for (std::size_t number = range.begin(); number != range.end(); ++number) {
            if (shared.cancelled())
                return;
            check(number);
        }
        shared.done(range.size());
    });
    if (progress.cancelled())
        return cancelledError(Message::marked("Verifying the model"));
    return {};
}

} // namespace tetra
