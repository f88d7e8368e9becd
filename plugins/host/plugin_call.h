// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/system_error.h"

#include <tan/base.h>

#include <exception>
#include <new>
#include <string>

namespace tetra {

inline Error outOfMemoryInPlugin(const std::string& id)
{
    return {
        ErrorKind::OutOfResource,
        Message::say(
            "The memory of this machine is not enough for '%1' here. Close other programs, or give it smaller data.",
            id)};
}

/// What a plugin threw that the C++ library's texts explain. A machine that can start no more threads is not the
/// plugin's fault.
inline Error thrownByPlugin(const std::string& id, const std::exception& problem)
{
    if (auto lack = lackOfResources(problem))
        return *std::move(lack);
    return {ErrorKind::BadInput,
            Message::say("The plugin '%1' failed: %2. This is a mistake in the plugin; tell its author.", id,
                         problem.what())};
}

/// Calls `work`, which gives a Result and belongs to the plugin `id`. Plugins should not throw; what one throws all the
/// same becomes an error here.
template <class Work> auto callPlugin(const std::string& id, Work&& work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return outOfMemoryInPlugin(id);
    } catch (const std::exception& problem) {
        return thrownByPlugin(id, problem);
    } catch (...) {
        return Error{ErrorKind::BadInput, Message::say("The plugin '%1' failed without saying why. This is a mistake "
                                                       "in the plugin; tell its author.",
                                                       id)};
    }
}

} // namespace tetra
