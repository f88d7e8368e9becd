// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/findings.h"
#include "plugins/readers/hdf5/hdf5_request.h"
#include "plugins/readers/hdf5/helper/hdf5_id.h"

#include <functional>

namespace tetra {

/// The array of an open file that is asked for, with its values. `bytes` of the file: what memory it may need. Errors:
/// sentences about "it".
Result<FileFindings> arrayFindings(hid_t file, std::uint64_t bytes, const Hdf5Request& request,
                                   const std::function<void(double)>& progress);

/// What the file holds, by its headers.
Result<FileContents> arrayContents(hid_t file, std::uint64_t bytes, const Hdf5Request& request);

} // namespace tetra
