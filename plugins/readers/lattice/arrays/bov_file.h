// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// Whether a file begins as headers of bricks do.
bool looksLikeBov(std::string_view beginning);

/// A brick of values of VisIt (.bov): a text header whose data file has the numbers, packed by gzip or not. Values of
/// zones lie in the middles of the cells. Errors say which line of the header does not fit.
Result<StoredVolume> describeBov(const VolumeRequest& request);

/// The data file.
std::vector<std::filesystem::path> companionsOfBov(const VolumeRequest& request);

} // namespace tetra
