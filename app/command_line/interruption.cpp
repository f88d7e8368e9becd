// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/interruption.h"

#include <tan/base.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <optional>

#include <pthread.h>
#include <unistd.h>

namespace tetra {
namespace {

constexpr int cancelledExit = 130;

sigset_t watchedSignals()
{
    sigset_t watched;
    sigemptyset(&watched);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&watched, signal);
    return watched;
}

/// The process for which this one works, if it is the one that started it.
std::optional<pid_t> masterOf()
{
    const char* const named = std::getenv("TAN_STOP_WITH");
    return named != nullptr ? parseNumber<pid_t>(named) : std::nullopt;
}

/// Waits in a thread of its own, because almost nothing may be done in a signal handler.
void wait(const std::stop_token& end, std::stop_source stop)
{
    const std::optional<pid_t> master = masterOf();
    const sigset_t watched = watchedSignals();
    constexpr timespec lookUpEvery{.tv_sec = 0, .tv_nsec = 50'000'000};
    while (!end.stop_requested()) {
        if (master && getppid() != *master)
            stop.request_stop();
        if (sigtimedwait(&watched, nullptr, &lookUpEvery) < 0)
            continue;
        if (stop.stop_requested())
            _exit(cancelledExit);
        stop.request_stop();
    }
}

} // namespace

Interruption::Interruption()
{
    const sigset_t watched = watchedSignals();
    pthread_sigmask(SIG_BLOCK, &watched, nullptr);
    waiter_ = std::jthread([stop = stop_](const std::stop_token& end) { wait(end, stop); });
}

Interruption::~Interruption() = default;

} // namespace tetra
