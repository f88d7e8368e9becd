// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Whether the lines at the beginning of a file are those of a cube.
bool looksLikeCube(std::string_view beginning);

/// A Gaussian cube (.cube, .cub): values of one or more orbitals or other quantities on a lattice at any angle, in
/// text, in bohr, or in angstrom where the counts of points are negative. Errors name the line.
Result<StoredVolume> describeCube(const VolumeRequest& request);

} // namespace tetra
