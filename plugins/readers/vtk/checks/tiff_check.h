// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Walks the chain of pages of TIFF files (BigTIFF too), one volume of one or more pages each: every page and all of
/// its strips or tiles must lie in the file, and all pages be of one size and type. Where the chain breaks, VTK takes
/// what came before as the whole volume. Reads the directories only.
Result<CheckedFile> checkTiff(const std::vector<std::filesystem::path>& paths);

} // namespace tetra
