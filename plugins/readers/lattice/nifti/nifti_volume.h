// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace tetra {

/// Whether a file begins as headers of NIfTI do, or of Analyze, if it has their name.
bool isNiftiHeader(const std::filesystem::path& path, std::span<const std::byte> firstBytes);

/// The header beside the samples "head.img" of a pair, a file that is no header itself; empty if there is none.
std::filesystem::path niftiHeaderBeside(const std::filesystem::path& path, std::span<const std::byte> firstBytes);

/// What a NIfTI file holds, or a pair of a header, which is the file of the request, and samples, also of Analyze 7.5.
/// The fourth dimension, and those behind it, are time steps; of vectors the fifth holds the components. Errors: no
/// such header; a type that is not read; sizes that cannot be.
Result<StoredVolume> niftiVolume(const VolumeRequest& request);

/// The other file of a pair, as it may be named.
std::vector<std::filesystem::path> niftiCompanions(const VolumeRequest& request);

} // namespace tetra
