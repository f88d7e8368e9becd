// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Whether a file begins with an object as OpenDX has them.
bool looksLikeDx(std::string_view beginning);

/// A field of an OpenDX file (.dx) on regular positions: numbers in text or binary, in the file or in another one.
/// Errors say what else its positions and values are, and what to export.
Result<StoredVolume> describeDx(const VolumeRequest& request);

/// The other file that has the numbers, if there is one.
std::vector<std::filesystem::path> companionsOfDx(const VolumeRequest& request);

} // namespace tetra
