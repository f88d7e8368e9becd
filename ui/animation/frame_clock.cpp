// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/animation/frame_clock.h"

namespace tetra {
namespace {

constexpr double newestCounts = 0.2;
/// A longer gap is the user's pause, not the time of a picture.
constexpr double longestFrame = 1; // seconds

} // namespace

double FrameClock::tick()
{
    if (!sinceLast_.isValid()) {
        sinceLast_.start();
        return 0;
    }
    const double seconds = 1e-9 * static_cast<double>(sinceLast_.nsecsElapsed());
    sinceLast_.start();
    if (seconds > 0 && seconds < longestFrame)
        secondsPerFrame_ =
            secondsPerFrame_ > 0 ? secondsPerFrame_ + newestCounts * (seconds - secondsPerFrame_) : seconds;
    return secondsPerFrame_ > 0 ? 1 / secondsPerFrame_ : 0;
}

void FrameClock::stop()
{
    sinceLast_.invalidate();
    secondsPerFrame_ = 0;
}

} // namespace tetra
