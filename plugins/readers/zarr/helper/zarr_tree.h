// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/zarr/helper/zarr_folder.h"

#include <tan/base.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tetra {

/// What a folder of Zarr holds, by paths in it, sorted as the folders are.
struct ZarrTree {
    std::vector<std::string> images; ///< of OME-Zarr
    std::vector<std::string> arrays; ///< others, of numbers along three axes or more
    std::size_t others = 0;          ///< arrays with fewer axes, or of what TAn does not read
    std::size_t damaged = 0;         ///< groups and arrays whose metadata cannot be read
    bool hasLabels = false;          ///< of OME-Zarr: numbers of the parts of a picture
    bool isCut = false;              ///< it goes on
};

/// Looks through the groups, not into arrays and images. Errors: those of the folder's own metadata.
Result<ZarrTree> zarrTree(const ZarrFolder& folder);

} // namespace tetra
