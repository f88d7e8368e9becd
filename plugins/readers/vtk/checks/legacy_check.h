// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Tells of a legacy VTK file what VTK's own message does not: that it holds tables, trees or graphs and nothing to
/// show. Remarks a text that ends within its last number, or right behind it. Reads the first lines and the last byte.
Result<CheckedFile> checkLegacy(const std::filesystem::path& path);

} // namespace tetra
