// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace tetra {

/// How long work tells how far it is, and hears that it should stop. A cheap value: pass by const reference,
/// copy into workers. All members may be called from any thread; the callback must bear that.
class Progress {
public:
    /// `fraction` in [0, 1], never decreasing within one piece of work; `activity` is a short text for the user.
    using Callback = std::function<void(double fraction, std::string_view activity)>;

    /// Silent and not cancellable.
    Progress() = default;
    Progress(std::stop_token stop, Callback callback) : stop_(std::move(stop)), callback_(std::move(callback)) {}

    /// Long work asks often enough to stop within a second.
    bool cancelled() const noexcept { return stop_.stop_requested() || otherStop_.stop_requested(); }

    void report(double fraction, std::string_view activity) const
    {
        if (callback_)
            callback_(first_ + fraction * (last_ - first_), activity);
    }

    /// The same progress for a step that covers [first, last] of the whole.
    Progress part(double first, double last) const
    {
        Progress result = *this;
        result.first_ = first_ + first * (last_ - first_);
        result.last_ = first_ + last * (last_ - first_);
        return result;
    }

    /// Cancelled by the same request, but reporting its own [0, 1] to `callback`: for one of several pieces of work
    /// that run at once, whose fractions the callback puts together.
    Progress withCallback(Callback callback) const
    {
        Progress result(stop_, std::move(callback));
        result.otherStop_ = otherStop_;
        return result;
    }

    /// The same progress, cancelled by another request as well, in place of one that was given before.
    Progress alsoCancelledBy(std::stop_token other) const
    {
        Progress result = *this;
        result.otherStop_ = std::move(other);
        return result;
    }

private:
    std::stop_token stop_;
    std::stop_token otherStop_;
    Callback callback_;
    double first_ = 0;
    double last_ = 1;
};

} // namespace tetra
