// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/vtk/helper/leaves.h"

#include <vtkAlgorithm.h>

#include <optional>

namespace tetra {

/// What UpdateInformation() of a reader told: nothing if that is not all arrays.
std::optional<FileContents> contentsFromInformation(vtkAlgorithm& reader);

/// What data are that were read.
FileContents contentsOf(const std::vector<VtkLeaf>& leaves, const std::string& part);

} // namespace tetra
