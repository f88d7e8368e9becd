// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd/nrrd_fields.h"

#include <tan/base.h>

#include <string>
#include <vector>

namespace tetra {

/// The data files of a detached header, in the order of the samples, relative to the header's folder; none if the data
/// follow the header. One, or several of the same number of samples each: 'data file: LIST' with a name in each line
/// below, or a pattern, 'slice%03d.raw 1 100 1', both perhaps with the dimensions that a file holds behind it. Errors:
/// another number of files than the sizes ask for; names that cannot be. The sizes must have been found right.
Result<std::vector<std::string>> nrrdDataFiles(const NrrdFields& fields);

} // namespace tetra
