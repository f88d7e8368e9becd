// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <algorithm>

/// Tests wait until something holds, and not for ever: at least a minute, because other programs slow them down, and
/// under a sanitizer five times as long. Whether less would have been enough says nothing.
namespace tetra {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool isAddressSanitized = true;
#else
constexpr bool isAddressSanitized = false;
#endif
#if defined(__SANITIZE_THREAD__)
constexpr bool isInstrumented = true;
#else
constexpr bool isInstrumented = isAddressSanitized;
#endif

/// Milliseconds to wait where these are enough on a quiet machine.
constexpr int patiently(int milliseconds)
{
    return (isInstrumented ? 5 : 1) * std::max(milliseconds, 60'000);
}

#undef QTRY_IMPL
#define QTRY_IMPL(expr, timeout)                                                                                       \
    {                                                                                                                  \
        QTRY_LOOP_IMPL(expr, tetra::patiently(timeout), (timeout) < 350 ? (timeout) / 7 + 1 : 50)                      \
    }

/// False if it does not hold in time. Handles events meanwhile.
template <class Predicate> bool waitFor(Predicate holds, int milliseconds = 5000)
{
    return QTest::qWaitFor(holds, patiently(milliseconds));
}

} // namespace tetra
