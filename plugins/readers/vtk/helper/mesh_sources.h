// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// Readers of simulation results: EnSight, CGNS, GAMBIT, Fluent, OpenFOAM, Tecplot.
Result<VtkSource> makeMeshSource(const VtkRequest& request);

} // namespace tetra
