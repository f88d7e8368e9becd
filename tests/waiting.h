// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

/// Tests wait until something holds, and not for ever. Instrumented programs are slower: they may take ten times as
/// long, and whether less would have been enough says nothing.
namespace tetra {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isInstrumented = true;
#undef QTRY_IMPL
#define QTRY_IMPL(expr, timeout)                                                                                       \
    {                                                                                                                  \
        QTRY_LOOP_IMPL(expr, 10 * (timeout), 50)                                                                       \
    }
#else
constexpr bool isInstrumented = false;
#endif

/// False if it does not hold in time. Handles events meanwhile.
template <class Predicate> bool waitFor(Predicate holds, int milliseconds = 5000)
{
    return QTest::qWaitFor(holds, (isInstrumented ? 10 : 1) * milliseconds);
}

} // namespace tetra
