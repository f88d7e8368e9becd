// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"
#include "plugins/readers/vtk/helper/vtk_log.h"

#include <vtkDataObject.h>

#include <functional>
#include <vector>

namespace tetra {

/// The times of a reader that was asked for information; empty if it has none.
std::vector<double> timesOf(vtkAlgorithm& reader);

/// Reads the wanted time step (from 1). The error is VTK's first, or says that there is no such step.
Result<vtkSmartPointer<vtkDataObject>> runSource(const VtkSource& source, std::int64_t timeStep, const VtkLog& log,
                                                 const std::function<void(double)>& progress);

} // namespace tetra
