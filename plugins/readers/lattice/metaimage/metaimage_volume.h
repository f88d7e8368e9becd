// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace tetra {

/// What a MetaImage holds, by the text that its file begins with: of three dimensions, or of more, which are time
/// steps. Errors: no header; a type that is not read; sizes that cannot be; a data file that is missing.
Result<StoredVolume> metaImageVolume(const VolumeRequest& request);

/// The data file if there is one of its own, as a path beside the header.
std::vector<std::filesystem::path> metaImageCompanions(const VolumeRequest& request);

/// Whether a file begins with fields that every MetaImage has.
bool looksLikeMetaImage(std::string_view firstBytes);

} // namespace tetra
