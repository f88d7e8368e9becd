// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// A reader of a PLOT3D grid with the solution or function file that the request names, or that lies beside it under
/// the same name. Of text files how many grids there are, and whether iblank, follows from how many numbers they have;
/// of binary ones VTK finds it out.
Result<VtkSource> makePlot3dSource(const VtkRequest& request);

} // namespace tetra
