// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <new>

namespace tetra {

/// Runs `work`, which returns a Result, on as many threads as are wanted; 0 or too many means all of the machine.
/// std::bad_alloc becomes an error.
template <class Work> auto onThreads(int threads, Work&& work) -> decltype(work())
{
    try {
        const int all = tbb::info::default_concurrency();
        tbb::task_arena arena(threads > 0 ? std::min(threads, all) : all);
        return arena.execute(work);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory for a picture of this size and scene. Make the "
                                               "picture smaller or lower the accuracy of the mesh."};
    }
}

} // namespace tetra
