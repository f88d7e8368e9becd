// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>

namespace tetra {

/// Measures how many pictures a second a movement shows: a mean over the last few.
class FrameClock {
public:
    /// A picture of a movement is on the screen. Returns the rate, 0 until it can be told.
    double tick();
    /// The movement is over.
    void stop();

private:
    QElapsedTimer sinceLast_;
    double secondsPerFrame_ = 0;
};

} // namespace tetra
