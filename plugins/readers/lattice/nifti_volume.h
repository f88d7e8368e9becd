// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored_volume.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace tetra {

/// What a NIfTI file holds, or a pair of a header and samples, also of Analyze 7.5; by the bytes of its header, of the
/// file `path`. The fourth dimension, and those behind it, are time steps; of vectors the fifth holds the components.
/// Errors: no such header; a type that is not read; sizes that cannot be.
Result<StoredVolume> niftiVolume(std::span<const std::byte> file, const std::filesystem::path& path,
                                 const VolumeChoice& choice);

} // namespace tetra
