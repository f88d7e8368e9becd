// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/progress_line.h"

#include "app/command_line/table.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

using namespace std::chrono_literals;

constexpr auto drawEvery = 100ms;
constexpr auto logEvery = 5s;
constexpr int barWidth = 30;

int percentOf(double fraction)
{
    return static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 100);
}

} // namespace

ProgressLine::ProgressLine(std::ostream& messages, bool isTerminal)
    : messages_(messages), isTerminal_(isTerminal), start_(Clock::now()), shown_(start_)
{
}

Progress ProgressLine::progress(std::stop_token stop)
{
    return {std::move(stop),
            [this](double fraction, const Message& activity) { report(fraction, visibleText(activity)); }};
}

void ProgressLine::clear()
{
    const std::lock_guard lock(mutex_);
    if (isTerminal_ && isShown_)
        messages_ << "\r\x1b[K" << std::flush;
    isShown_ = false;
}

void ProgressLine::report(double fraction, std::string_view activity)
{
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    remainingTime_.update(fraction, std::chrono::duration<double>(now - start_).count());
    if (now - shown_ < (isTerminal_ ? Clock::duration(drawEvery) : Clock::duration(logEvery)))
        return;
    shown_ = now;
    if (isTerminal_)
        draw(fraction, activity);
    else
        log(fraction, activity);
}

std::string ProgressLine::remaining() const
{
    const auto seconds = remainingTime_.seconds();
    return seconds ? ", " + durationText(std::max(*seconds, 1.0)) + " left" : "";
}

void ProgressLine::draw(double fraction, std::string_view activity)
{
    const int filled = percentOf(fraction) * barWidth / 100;
    messages_ << "\r[" << std::string(filled, '#') << std::string(barWidth - filled, '.') << "] "
              << std::to_string(percentOf(fraction)) << " %  " << activity << remaining() << "\x1b[K" << std::flush;
    isShown_ = true;
}

void ProgressLine::log(double fraction, std::string_view activity)
{
    if (percentOf(fraction) == shownPercent_)
        return;
    shownPercent_ = percentOf(fraction);
    messages_ << activity << ": " << std::to_string(shownPercent_) << " %" << remaining() << "\n" << std::flush;
}

} // namespace tetra
