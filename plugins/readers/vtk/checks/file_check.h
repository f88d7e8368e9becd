// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <filesystem>

namespace tetra {

/// Looks at what is asked for before VTK does, each format by its own check in this folder; of those whose libraries
/// look by themselves (HDF5) only at how much there is. Reads each file at most once, and holds none.
Result<CheckedFile> checkBeforeVtk(const VtkRequest& request);

/// Whether the contents of a file whose headers alone tell them (CGNS) are told by these, since it would take long to
/// read it: neither are then its data looked at for what VTK reads wrongly.
bool isToldByHeaders(const std::filesystem::path& path);

} // namespace tetra
