// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Looks whether each section of a Fluent case (.cas), and of its data (.dat) beside it, ends. VTK leaves out a text
/// section that does not, and reads for ever in a binary one. Linear.
Result<CheckedFile> checkFluent(const std::filesystem::path& path);

} // namespace tetra
