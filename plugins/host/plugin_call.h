// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <exception>
#include <new>
#include <string>

namespace tetra {

/// Calls `work`, which gives a Result and belongs to the plugin `id`. Plugins should not throw; what one throws all the
/// same becomes an error here.
template <class Work> auto callPlugin(const std::string& id, Work&& work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "The memory of this machine is not enough for '" + id +
                                                   "' here. Close other programs, or give it smaller data."};
    } catch (const std::exception& problem) {
        return Error{ErrorKind::BadInput, "The plugin '" + id + "' failed: " + problem.what() +
                                              ". This is a mistake in the plugin; tell its author."};
    }
}

} // namespace tetra
