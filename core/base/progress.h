// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace tetra {

/// Of work that makes what is kept whole: it reports to `progress`, but is cancelled only where that is cancelled and
/// isKept() says no, which each report asks.
inline Progress untilGivenUp(const Progress& progress, std::function<bool()> isKept)
{
    const std::stop_source givenUp;
    return {givenUp.get_token(),
            [progress, isKept = std::move(isKept), givenUp](double fraction, const Message& activity) {
                progress.report(fraction, activity);
                if (progress.cancelled() && !isKept())
                    givenUp.request_stop();
            }};
}

/// Progress of work that many threads do in pieces: adds up what they have done and reports it in order, so that the
/// fraction never falls.
class SharedProgress {
public:
    SharedProgress(const Progress& progress, double total, const Message& activity)
        : progress_(progress), total_(std::max(total, 1.0)), activity_(activity)
    {
    }

    bool cancelled() const noexcept { return progress_.cancelled(); }
    /// From any thread.
    void done(double amount)
    {
        const std::lock_guard lock(mutex_);
        done_ += amount;
        progress_.report(std::min(1.0, done_ / total_), activity_);
    }
    /// What a piece of that amount, which reports its own fractions, is given to call. It is done when it reports 1.
    Progress::Callback piece(double amount)
    {
        return [this, amount, told = std::make_shared<double>(0)](double fraction, const Message&) {
            done((fraction - std::exchange(*told, fraction)) * amount);
        };
    }

private:
    Progress progress_;
    double total_;
    Message activity_;
    std::mutex mutex_;
    double done_ = 0;
};

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

/// Guesses how long work will still take from the fractions that it reports. Recent speed counts most, so that a slow
/// second half is noticed; a short stall moves the guess little. Knows no clock: the caller says what time it is.
class TAN_INTERNAL RemainingTime {
public:
    /// `fraction` in [0, 1] was reached `seconds` after the start. Calls that go back in either are ignored.
    void update(double fraction, double seconds) noexcept;

    /// Seconds left after the last update; nothing until a second has passed and something was done.
    std::optional<double> seconds() const noexcept;

private:
    double fraction_ = 0;
    double seconds_ = 0;
    double speed_ = 0;  ///< fraction a second, recent intervals weighing more
    double weight_ = 0; ///< how much of speed_ is measured; the rest is still the zero that it started from
};

} // namespace tetra
