// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <algorithm>
#include <cstdint>

/// Two tiers: ./dev test proves each behaviour once, on every change; ./dev soak repeats it, with chances of its own.
/// Which tests differ between them, or are in the second one alone, tests/CMakeLists.txt lists.
namespace tetra {

/// Whether this run is of the second tier: TAN_SOAK is the seed of its chances then.
inline bool isSoak()
{
    return qEnvironmentVariableIsSet("TAN_SOAK");
}

/// How many of something: in ./dev test, and in ./dev soak.
template <class Number> Number timesOf(Number once, Number often)
{
    return isSoak() ? often : once;
}

/// Of rows that combine everything with everything, which `row` counts: all in ./dev soak, each nth in ./dev test. With
/// an n that divides no number of choices everything is in one of them.
inline bool takesRow(int& row, int n = 3)
{
    return isSoak() || row++ % n == 0;
}

/// Milliseconds in which what somebody waits for is over: these in ./dev soak, which leaves the machine to tests of
/// latencies; a minute at least in ./dev test, where others have the processor, too.
inline qint64 soon(qint64 onAQuietMachine)
{
    return isSoak() ? onAQuietMachine : std::max<qint64>(onAQuietMachine, 60'000);
}

/// The seed of a test's chances: always `usual` in ./dev test, another one for each run of ./dev soak.
inline std::uint32_t seedOf(std::uint32_t usual)
{
    return usual + 0x9e3779b9u * static_cast<std::uint32_t>(qEnvironmentVariableIntValue("TAN_SOAK"));
}

} // namespace tetra
