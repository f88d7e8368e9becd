// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_guards.h"

namespace tetra {

/// A reader as the program has it, with what the host does for all of them (plugin_guards.h).
template <class Tested> const Reader& asLoaded()
{
    static const Tested reader;
    static const std::unique_ptr<const Reader> guard = guarded(reader, {"tested", [](const Error&) {}});
    return *guard;
}

/// What the program makes of it: grids with their holes.
inline Result<Dataset> complete(const Result<Dataset>& read)
{
    return read ? withHoles(*read) : read;
}

} // namespace tetra
