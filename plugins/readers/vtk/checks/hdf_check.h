// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Tells which HDF files are none of VTK's, or of a kind that VTK 9.1 does not know, by the names of groups and types
/// that stand in them; VTK's own messages say only what it looked for first. Whether a file is whole, the library of
/// HDF5 sees. Reads up to the name that decides, at most the first megabytes.
Result<CheckedFile> checkVtkHdf(const std::filesystem::path& path);

} // namespace tetra
