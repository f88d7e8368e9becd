// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/netcdf/netcdf_request.h"

namespace tetra {

/// What can be chosen of NetCDF and Exodus files.
std::vector<Parameter> netCdfParameters();

/// The choices as the reading program takes them; the path is left to be filled in.
NetCdfRequest netCdfRequest(const ParameterValues& values);

} // namespace tetra
