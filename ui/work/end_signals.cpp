// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/end_signals.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>

#include <sys/eventfd.h>
#include <unistd.h>

namespace tetra {
namespace {

constexpr std::array endSignals{SIGTERM, SIGINT, SIGHUP};

/// What the handler writes to. A handler can be given nothing but what is global.
std::atomic<int> told{-1};

/// Almost nothing may be done here.
void tell(int)
{
    const int before = errno;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(told, &one, sizeof one);
    errno = before;
}

} // namespace

EndSignals::EndSignals(QObject* parent)
    : QObject(parent), notifier_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), QSocketNotifier::Read)
{
    connect(&notifier_, &QSocketNotifier::activated, this, [this] {
        std::uint64_t count = 0;
        if (::read(static_cast<int>(notifier_.socket()), &count, sizeof count) > 0)
            emit endWanted();
    });
    told = static_cast<int>(notifier_.socket());
    for (const int signal : endSignals) {
        struct sigaction action {};
        if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN)
            continue;
        action = {};
        action.sa_handler = tell;
        action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
        ::sigaction(signal, &action, nullptr);
    }
}

EndSignals::~EndSignals()
{
    for (const int signal : endSignals) {
        struct sigaction action {};
        if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == tell)
            ::signal(signal, SIG_DFL);
    }
    ::close(told.exchange(-1));
}

} // namespace tetra
