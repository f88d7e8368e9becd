// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <thread>

namespace tetra {

/// Turns the first SIGINT, SIGTERM or SIGHUP of this process into a stop request; a second one ends the process at
/// once. So does the end of the process whose number is in TAN_STOP_WITH, for which this one works: whoever is killed
/// cannot stop it. Make it before any other thread, which then leaves the signals to it.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    std::stop_token token() const { return stop_.get_token(); }

private:
    std::stop_source stop_;
    std::jthread waiter_;
};

} // namespace tetra
