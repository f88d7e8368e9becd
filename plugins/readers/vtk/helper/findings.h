// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/leaves.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

namespace tetra {

/// What the request asks for out of what VTK read: one part, or all volumes that have the values as one mesh. Of grids
/// that do not fit into memory together the first alone. The error says what is not there, and what is.
Result<VtkFindings> findingsOf(const std::vector<VtkLeaf>& leaves, const VtkRequest& request);

} // namespace tetra
