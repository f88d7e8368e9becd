// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/exchange.h"
#include "plugins/process/findings.h"
#include "plugins/readers/vtk/vtk_format.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

using VtkFindings = FileFindings;
using VtkDataKind = FoundKind;

/// What the helper program is asked for.
struct VtkRequest {
    bool contentsOnly = false; ///< probe() instead of read()
    VtkFormat format = VtkFormat::None;
    std::string path;
    std::string array;                ///< a name, or a number from 1; "automatic"
    std::string component;            ///< a number from 0, or "magnitude"; empty: the user did not choose
    std::int64_t timeStep = 0;        ///< from 1; 0: the user did not choose, which takes the first
    std::string part;                 ///< a name, or a number from 1; empty: what fits together
    std::vector<std::string> given{}; ///< givenPlacement(), which the helper refuses for what the file tells
    bool joinsGrids = true;           ///< several grids become one mesh; false: the first one alone is taken
};

/// Source::leftOut of grids that were not joined, with the reason, a sentence.
inline Message notJoinedText(const Message& reason)
{
    return Message::say("Its grids do not make a mesh together, and only the first one is read. %1", reason);
}

template <class Archive> void exchange(Archive& archive, VtkRequest& request)
{
    exchangeAll(archive, request.contentsOnly, request.format, request.path, request.array, request.component,
                request.timeStep, request.part, request.given, request.joinsGrids);
}

} // namespace tetra
