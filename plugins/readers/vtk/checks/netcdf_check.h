// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Holds the header of a NetCDF file in one of the classic formats (CDF-1, 64-bit offset, CDF-5; Exodus too) against
/// the size of the file: its lists must lie in it, and so must the end of every variable, over all records. The library
/// of NetCDF gives zeros for what lies behind the end, and memory for any number that a header names. Other files
/// (NetCDF-4 is HDF5, whose library looks by itself) are only measured. Linear in the header; the data are not read.
Result<CheckedFile> checkNetCdf(const std::filesystem::path& path);

} // namespace tetra
