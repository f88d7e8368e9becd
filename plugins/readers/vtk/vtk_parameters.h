// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/readers/vtk/vtk_findings.h"

namespace tetra {

/// What can be chosen of a file that VTK reads.
std::vector<Parameter> vtkParameters();

/// The choices as the helper program takes them; path and format are left to be filled in.
VtkRequest vtkRequest(const ParameterValues& values);

} // namespace tetra
