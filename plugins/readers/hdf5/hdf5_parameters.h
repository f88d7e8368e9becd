// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/hdf5/hdf5_request.h"

namespace tetra {

/// What can be chosen of the arrays in HDF5 files.
std::vector<Parameter> hdf5Parameters();

/// The choices as the reading program takes them; the path is left to be filled in.
Hdf5Request hdf5Request(const ParameterValues& values);

} // namespace tetra
