// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Looks at all DICOM files of the folder that the file lies in, which VTK takes for one volume: each must have all its
/// elements and pixels, unpacked, of 8 or 16 bits, and all be of one size. VTK passes over files that it cannot begin
/// to read, and takes the pixels of another file where there are none. Reads the elements before the pixels only.
Result<CheckedFile> checkDicom(const std::filesystem::path& path);

} // namespace tetra
