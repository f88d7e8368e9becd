// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Holds an MRC or CCP4 map against its header of 1,024 bytes: all samples of its size and type must lie behind it and
/// its extension. Refuses those with the bytes of numbers in the other order, of which VTK 9.1 turns the first line
/// alone. Reads the header only.
Result<CheckedFile> checkMrc(const std::filesystem::path& path);

} // namespace tetra
