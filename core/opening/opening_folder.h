// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_folder.h"
#include "core/remote/cache_folder.h"

#include <tan/open.h>

#include <memory>

namespace tetra {

/// Where an opening puts what it fetches and unpacks.
struct OpeningFolder {
    CacheFolder folder;
    std::shared_ptr<const WorkFolder> own; ///< that is in, if nobody else finds it; it goes with the last copy
};

/// The cache that the options name or, where that cannot be used, a folder of this opening's own. Errors: neither can
/// be had, what is said of the cache; WrongUsage for a TAN_CACHE_MB that is not a number.
Result<OpeningFolder> openingFolder(const OpenOptions& options);

/// A folder of its own among the system's temporary files, with the same limit. Errors: it cannot be made.
Result<OpeningFolder> folderOfItsOwn(const OpenOptions& options);

} // namespace tetra
