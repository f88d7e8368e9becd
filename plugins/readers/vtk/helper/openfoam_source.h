// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// An OpenFOAM case, of which `path` is a file in its folder (often empty, "case.foam") or system/controlDict. Where it
/// lies in folders of processors, these are taken if there is no mesh beside them, or if they have later times. Values
/// of cells are those of the file: VTK's means at points, which do not cross processors, are not made. Errors say what
/// the case lacks.
Result<VtkSource> makeOpenFoamSource(const std::string& path);

} // namespace tetra
