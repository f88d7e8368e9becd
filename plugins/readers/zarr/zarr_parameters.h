// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/zarr/zarr_request.h"

#include <tan/base.h>

#include <map>
#include <string>
#include <vector>

namespace tetra {

/// What can be chosen of Zarr.
std::vector<Parameter> zarrParameters();

/// The choices as the reading program takes them; the folder is left to be filled in.
ZarrRequest zarrRequest(const ParameterValues& values);

/// "angle=3, type=1": numbers from 1 by the names of axes. Error (WrongUsage): what is not understood.
Result<std::map<std::string, std::uint64_t>> parseAxisNumbers(const std::string& text);

} // namespace tetra
