// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/version.h>

namespace tetra {

LibraryVersion libraryVersion() noexcept
{
    return {TAN_VERSION_MAJOR, TAN_VERSION_MINOR, TAN_VERSION_PATCH};
}

} // namespace tetra
