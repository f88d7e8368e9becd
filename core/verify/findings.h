// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <tan/base.h>
#include <tan/verify.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
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

/// What is measured at each point: of several numbers the largest, or the smallest. Threads may raise or lower at once;
/// what comes of it is the same with any number of them.
class PointResiduals {
public:
    /// `initial`: 0 to raise, infinity to lower.
    PointResiduals(std::size_t points, double initial) : residuals_(points)
    {
        for (std::atomic<double>& residual : residuals_)
            residual.store(initial, std::memory_order_relaxed);
    }

    std::size_t size() const { return residuals_.size(); }
    double at(std::size_t point) const { return residuals_[point].load(std::memory_order_relaxed); }
    void raise(std::size_t point, double residual)
    {
        for (double known = at(point); known < residual && !exchange(point, known, residual);)
            ;
    }
    void lower(std::size_t point, double residual)
    {
        for (double known = at(point); residual < known && !exchange(point, known, residual);)
            ;
    }

    /// Of the points that `counts(point)` says yes of; residuals are multiplied by `factor`. O(points).
    template <class Counts> ResidualStatistics statistics(double factor, const Counts& counts) const
    {
        std::vector<double> numbers;
        numbers.reserve(residuals_.size());
        double sum = 0, squares = 0;
        for (std::size_t point = 0; point < residuals_.size(); ++point) {
            if (!counts(point))
                continue;
            const double number = numbers.emplace_back(factor * at(point));
            sum += number;
            squares += number * number;
        }
        if (numbers.empty())
            return {};
        const auto count = static_cast<double>(numbers.size());
        const auto percentile = numbers.begin() + static_cast<std::ptrdiff_t>((numbers.size() * 99 + 99) / 100 - 1);
        std::ranges::nth_element(numbers, percentile);
        const double largest = *std::max_element(percentile, numbers.end());
        return {largest, sum / count, *percentile, std::sqrt(squares / count)};
    }
    ResidualStatistics statistics(double factor) const
    {
        return statistics(factor, [](std::size_t) { return true; });
    }

private:
    bool exchange(std::size_t point, double& known, double residual)
    {
        return residuals_[point].compare_exchange_weak(known, residual, std::memory_order_relaxed);
    }

    std::vector<std::atomic<double>> residuals_;
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
