// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/images/images_request.h"
#include "plugins/readers/images/tiff/image_description.h"
#include "plugins/readers/images/tiff/tiff_file.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// A page of one of several files.
struct TiffPlane {
    std::size_t file = 0;
    std::uint64_t page = 0;
};

/// The pages that are the slices of one volume, and how they were chosen.
struct TiffPlanes {
    std::vector<std::filesystem::path> files{};
    std::vector<TiffPlane> slices{};
    std::vector<double> heights{}; ///< of each slice, in steps; empty: 0, 1, 2 ...
    PictureDescription description{};
    bool hasDescription = false;         ///< ImageJ's or OME's
    std::vector<std::string> channels{}; ///< names of all that there are, if there are several
    std::vector<std::string> series{};   ///< the same of volumes
    std::uint64_t times = 1;
    std::vector<Message> remarks{};
    std::vector<Taken> taken{}; ///< in the order of TakenPart
    std::vector<Message> leftOut{};
};

/// Finds them by what the file's texts and names say: OME's description, ImageJ's, pages, numbered files. The error
/// says what is wrong with "it", or with the request. May throw std::bad_alloc.
Result<TiffPlanes> tiffPlanes(const std::filesystem::path& path, const TiffFile& file, const ImagesRequest& request);

} // namespace tetra
