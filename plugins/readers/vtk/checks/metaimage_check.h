// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Holds a MetaImage (.mha, or .mhd with its data in other files) against its header: all samples that its sizes, type
/// and channels ask for must be there, in the file itself, in one file, a list or a numbered series; packed ones are
/// unpacked to count them, texts are gone through. What VTK would read wrongly is refused, too. Errors name the file
/// that is missing or short.
Result<CheckedFile> checkMetaImage(const std::filesystem::path& path);

} // namespace tetra
