// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <filesystem>
#include <vector>

namespace tetra {

/// What a NRRD header means, with the data behind it or in files of their own (.nhdr), raw, gzip or text. Of vectors,
/// colours and the like a component is taken, or the magnitude; of an axis of time, or of a list, one step. Errors:
/// what is missing, contradicts itself, or is not read (blocks, encodings); matrices of which no component is chosen,
/// where the magnitude means nothing.
Result<StoredVolume> nrrdVolume(const VolumeRequest& request);

/// The data file if there is one of its own.
std::vector<std::filesystem::path> nrrdCompanions(const VolumeRequest& request);

} // namespace tetra
