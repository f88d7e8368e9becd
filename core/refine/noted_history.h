// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/build.h>

namespace tetra {

/// A history on its way to the sink that it is for, and noted in a build's state on the way, so that a build that goes
/// on from there can hand it over again: what is made of a history cannot go back to an earlier one.
class NotedHistory final : public HistorySink {
public:
    /// Both outlive it. `state`: null to note nothing.
    NotedHistory(HistorySink& next, SavedState* state)
        : next_(next), state_(state), goesOn_(state != nullptr && state->found())
    {
    }

    /// Whether there is a state to go on from. Until goOn() the steps of a beginning are then nobody's.
    bool goesOn() const noexcept { return goesOn_; }
    /// Hands over what was noted before, and makes the space (core/refine/greedy.h) what it was then. Nothing is done
    /// if there is no state to go on from. Errors: the sink's, a state that cannot be read.
    template <class Space> Status goOn(Space& space, const Progress& progress)
    {
        if (!goesOn_)
            return {};
        goesOn_ = false;
        progress.report(0, Message::marked("Restoring the interrupted build"));
        const Status handed = handAgain();
        return handed ? state_->load(space) : handed;
    }

    Status begin(const HistoryTraits& traits) override { return next_.begin(traits); }
    Status add(const HistoryStep& step) override;
    Status finish(float finalKey) override { return next_.finish(finalKey); }

private:
    Status handAgain();

    HistorySink& next_;
    SavedState* state_;
    bool goesOn_;
};

} // namespace tetra
