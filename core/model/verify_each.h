// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/model/shared_progress.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <string>

namespace tetra {

/// Calls check(number) for every number below `count`, on all threads of the current arena, `atOnce` of them in a row.
/// The progress reads `activity`. An Error only if it was cancelled; then nothing further is begun.
template <class Check> Status verifyEach(std::size_t count, std::size_t atOnce, std::string activity,
                                         const Progress& progress, const Check& check)
{
    SharedProgress shared(progress, count, std::move(activity));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, atOnce), [&](const auto& range) {
        for (std::size_t number = range.begin(); number != range.end(); ++number) {
            if (shared.cancelled())
                return;
            check(number);
        }
        shared.done(range.size());
    });
    if (progress.cancelled())
        return cancelledError("Verifying the model");
    return {};
}

} // namespace tetra
