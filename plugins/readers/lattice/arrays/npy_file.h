// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Whether a file begins as NumPy's arrays do.
bool looksLikeNpy(std::string_view beginning);

/// What the dimensions of an array are: "xyz" or "zyx".
inline constexpr const char* npyAxesId = "axes";
Parameter npyAxesParameter();

/// An array of NumPy (.npy, versions 1 to 3): of three dimensions, or of more if all but three have one element, of
/// real or complex numbers. Unless the user says otherwise, array[i, j, k] is point (i, j, k), in either order of
/// storage, which is a guess. The numbers stay in the file if x runs fastest there. Errors say what else the array is,
/// and how to save one that can be read.
Result<StoredVolume> describeNpy(const VolumeRequest& request);

} // namespace tetra
