// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/interruption.h"

#include <csignal>
#include <ctime>

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

/// Waits in a thread of its own, because almost nothing may be done in a signal handler.
void wait(const std::stop_token& end, std::stop_source stop)
{
    const sigset_t watched = watchedSignals();
    constexpr timespec lookUpEvery{.tv_sec = 0, .tv_nsec = 50'000'000};
    while (!end.stop_requested()) {
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
