// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <cstddef>
#include <mutex>
#include <string_view>

namespace tetra {

/// Counts finished tiles for all threads, so that the fraction never falls.
class TileProgress {
public:
    TileProgress(const Progress& progress, std::size_t tiles, std::string_view activity)
        : progress_(progress), tiles_(tiles), activity_(activity)
    {
    }
    void tileDone()
    {
        const std::scoped_lock lock(mutex_);
        progress_.report(static_cast<double>(++done_) / static_cast<double>(tiles_), activity_);
    }

private:
    Progress progress_;
    std::size_t tiles_;
    std::string_view activity_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

} // namespace tetra
