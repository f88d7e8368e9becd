// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/volume_description.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

/// A format whose header describes the volume, with its data in the file or beside it.
struct VolumeFormat {
    std::string_view filter; ///< "Text (*.one *.two)", marked
    /// As Reader::score(): `ending` with its dot, in small letters.
    double (*score)(std::string_view ending, std::string_view beginning);
    Result<VolumeDescription> (*describe)(const VolumeRequest& request);
    std::vector<std::filesystem::path> (*companions)(const VolumeRequest& request); ///< may be null
};

std::span<const VolumeFormat> volumeFormats();

/// The format with the highest score, which is told in `score`; null if it is 0 for all.
const VolumeFormat* volumeFormatOf(const std::filesystem::path& path, std::string_view beginning, double& score);

} // namespace tetra
