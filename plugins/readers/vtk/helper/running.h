// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"
#include "plugins/readers/vtk/helper/vtk_log.h"

#include <vtkDataObject.h>

#include <functional>
#include <vector>

namespace tetra {

/// The times of a source whose reader was asked for information; empty if it has none.
std::vector<double> timesOf(const VtkSource& source);

/// Reads the time step that the request asks for. The error is VTK's first, or says that there is no such step.
Result<vtkSmartPointer<vtkDataObject>> runSource(const VtkSource& source, const VtkRequest& request, const VtkLog& log,
                                                 const std::function<void(double)>& progress);

} // namespace tetra
