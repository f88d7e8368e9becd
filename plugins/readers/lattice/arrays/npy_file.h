// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Whether a file begins as NumPy's arrays do.
bool looksLikeNpy(std::string_view beginning);

/// An array of NumPy (.npy, versions 1 to 3): of three dimensions, or of more if all but three have one element, of
/// real or complex numbers. The dimension that runs fastest becomes x, which is a guess. The numbers stay in the file
/// where they can. Errors say what else the array is, and how to save one that can be read.
Result<StoredVolume> describeNpy(const VolumeRequest& request);

} // namespace tetra
