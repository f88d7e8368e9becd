// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/findings.h"
#include "plugins/process/reading_program.h"
#include "plugins/readers/netcdf/helper/netcdf_file.h"
#include "plugins/readers/netcdf/netcdf_request.h"

namespace tetra {

/// A grid of a NetCDF file: the variable that is asked for, else the first that is not constant, at one time step.
Result<FileFindings> gridFindings(const NetCdfFile& file, const NetCdfRequest& request, const TellProgress& progress);

/// What it holds. Values are read only where a constant variable might be passed over, and there are few.
Result<FileContents> gridContents(const NetCdfFile& file, const NetCdfRequest& request);

} // namespace tetra
