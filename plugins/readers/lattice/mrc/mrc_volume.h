// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

namespace tetra {

/// What an MRC or CCP4 map holds, by the bytes it begins with. Numbers are signed bytes, shorts of either kind, floats
/// and halves; complex ones and pictures in colours are volumes of two and three components. A stack of volumes (space
/// groups from 401) has a time step for each. Errors: no map; a mode that is not read; sizes that cannot be.
Result<StoredVolume> mrcVolume(const VolumeRequest& request);

} // namespace tetra
