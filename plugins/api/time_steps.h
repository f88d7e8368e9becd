// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>

namespace tetra {

/// An error (WrongUsage) of every reader alike, a sentence about "it": the user asks for a time step, from 1, of a file
/// that has so many.
inline Error noSuchTimeStep(std::uint64_t steps, std::int64_t wanted)
{
    return {ErrorKind::WrongUsage,
            steps < 2 ? Message::say("it has one time step, and number %1 was requested. Leave '--time' out.", wanted)
                      : Message::say("it has %1 time steps, and number %2 was requested. Give one from 1 to %1.", steps,
                                     wanted)};
}

} // namespace tetra
