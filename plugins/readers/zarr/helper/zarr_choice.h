// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/zarr/helper/zarr_array.h"
#include "plugins/readers/zarr/helper/zarr_copying.h"
#include "plugins/readers/zarr/zarr_request.h"

#include <tan/base.h>
#include <tan/data.h>

#include <string>
#include <vector>

namespace tetra {

/// What is to be read, all of it known from metadata, and what there was to choose from.
struct ZarrChoice {
    ZarrArray array;
    ZarrSelection selection;
    Lattice lattice;
    std::string lengthUnit{};
    std::string arrayName{};           ///< of arrays that have one; images have none
    std::vector<std::string> untold{}; ///< as FileContents::untold
    std::vector<std::string> arrays{}; ///< paths
    std::vector<std::string> levels{}; ///< paths within the image
    std::vector<std::string> series{}; ///< paths of images
    std::vector<std::string> channels{};
    std::vector<double> timeSteps{};
    std::vector<Taken> taken{};
    std::vector<Message> leftOut{};
    std::vector<Message> remarks{};
};

/// Chooses the array, and of it the volume, that a request asks for. Errors, sentences about "it", the folder.
Result<ZarrChoice> chooseZarr(const ZarrFolder& folder, const ZarrRequest& request);

} // namespace tetra
