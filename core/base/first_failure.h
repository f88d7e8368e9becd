// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <mutex>
#include <stop_token>

namespace tetra {

/// Pieces of work that run at once and are of no use without each other: the first that fails, by an Error or by an
/// exception, stops the others.
class FirstFailure {
public:
    /// What a piece asks and tells: `progress`, cancelled by the first failure, too.
    Progress watching(const Progress& progress) const { return progress.alsoCancelledBy(stop_.get_token()); }
    /// Whether a piece has failed: those that were not begun need not be.
    bool happened() const noexcept { return stop_.stop_requested(); }

    /// Does a piece, `Status piece()`, on the calling thread. Its exceptions go on to the caller.
    template <class Piece> void run(Piece&& piece)
    {
        try {
            if (const Status status = piece(); !status)
                note(status);
        } catch (...) {
            stop_.request_stop();
            throw;
        }
    }

    /// The first Error, when all pieces have ended.
    const Status& status() const noexcept { return status_; }

private:
    void note(const Status& status)
    {
        const std::lock_guard lock(mutex_);
        if (status_)
            status_ = status;
        stop_.request_stop();
    }

    std::stop_source stop_;
    std::mutex mutex_;
    Status status_;
};

} // namespace tetra
