// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/vtk/helper/leaves.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <vtkAlgorithm.h>

#include <optional>

namespace tetra {

/// What UpdateInformation() of a reader told: nothing if that is not all arrays. Taken as far as it shows: which arrays
/// are the same everywhere need not.
std::optional<FileContents> contentsFromInformation(vtkAlgorithm& reader, const VtkRequest& request);

/// What data are that were read; of one part, if the request names one.
FileContents contentsOf(const std::vector<VtkLeaf>& leaves, const VtkRequest& request);

} // namespace tetra
