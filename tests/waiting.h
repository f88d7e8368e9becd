// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

/// Tests wait until something holds, and not for ever: ten times as long as Qt would, because other programs and
/// sanitizers slow them down, and whether less would have been enough says nothing.
namespace tetra {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isInstrumented = true;
#else
constexpr bool isInstrumented = false;
#endif

#undef QTRY_IMPL
#define QTRY_IMPL(expr, timeout)                                                                                       \
    {                                                                                                                  \
        QTRY_LOOP_IMPL(expr, 10 * (timeout), (timeout) < 350 ? (timeout) / 7 + 1 : 50)                                 \
    }

/// False if it does not hold in time. Handles events meanwhile.
template <class Predicate> bool waitFor(Predicate holds, int milliseconds = 5000)
{
    return QTest::qWaitFor(holds, 10 * milliseconds);
}

} // namespace tetra
