// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>

#include <vector>

namespace tetra {

/// What must be known of a raw file: size, type, byte-order, skip, spacing, origin, unit.
std::vector<Parameter> rawParameters();

/// Whether they say how many points there are, without which nothing is known of a raw file.
bool describesSize(const ParameterValues& values);

/// The volume that the user's parameters describe, all but where it lies. Errors: ErrorKind::WrongUsage for what is
/// missing, with what would fit the file's name and size, or cannot be understood.
Result<StoredVolume> rawVolume(const VolumeRequest& request);

} // namespace tetra
