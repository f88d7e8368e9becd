// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <string>

namespace tetra {

/// Progress of work that many threads do in pieces: adds up what they have done and reports it in order.
class SharedProgress {
public:
    SharedProgress(const Progress& progress, std::uint64_t total, std::string activity)
        : progress_(progress), total_(std::max<std::uint64_t>(total, 1)), activity_(std::move(activity))
    {
    }

    bool cancelled() const noexcept { return progress_.cancelled(); }
    /// From any thread.
    void done(std::uint64_t amount)
    {
        const std::lock_guard lock(mutex_);
        done_ += amount;
        progress_.report(static_cast<double>(done_) / static_cast<double>(total_), activity_);
    }

private:
    const Progress& progress_;
    std::uint64_t total_;
    std::string activity_;
    std::mutex mutex_;
    std::uint64_t done_ = 0;
};

} // namespace tetra
