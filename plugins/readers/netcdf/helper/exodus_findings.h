// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/findings.h"
#include "plugins/process/reading_program.h"
#include "plugins/readers/netcdf/helper/exodus_file.h"
#include "plugins/readers/netcdf/netcdf_request.h"

namespace tetra {

/// The mesh of an Exodus file: all element blocks of volumes that have the values, or the one that is asked for, at one
/// time step. The array is the one that is asked for, else the first that is not constant, those at nodes first. Of
/// files that have flat elements alone: the nodes, as points. Nodes are moved by displacements only on request.
Result<FileFindings> exodusFindings(const NetCdfFile& file, const NetCdfRequest& request, const TellProgress& progress);

/// What it holds; reads no values.
Result<FileContents> exodusContents(const NetCdfFile& file, const NetCdfRequest& request);

} // namespace tetra
