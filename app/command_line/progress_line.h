// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <tan/base.h>

#include <chrono>
#include <mutex>
#include <ostream>
#include <string>

namespace tetra {

/// Shows progress to someone at a terminal as one line that is drawn over and over: a bar, the percentage, what is
/// being done, and the time that remains. Elsewhere (a log file) it is a line every few seconds. Any thread may report.
class ProgressLine {
public:
    ProgressLine(std::ostream& messages, bool isTerminal);

    /// Reports to this line, which must outlive it.
    Progress progress(std::stop_token stop);
    /// Takes the line off the terminal, before other messages.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void report(double fraction, std::string_view activity);
    std::string remaining() const;
    void draw(double fraction, std::string_view activity);
    void log(double fraction, std::string_view activity);

    std::ostream& messages_;
    bool isTerminal_;
    std::mutex mutex_;
    RemainingTime remainingTime_;
    Clock::time_point start_;
    Clock::time_point shown_;
    bool isShown_ = false;
    int shownPercent_ = -1;
};

} // namespace tetra
