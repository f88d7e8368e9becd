// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <vtkUnstructuredGrid.h>

namespace tetra {

/// Adds the cells of `mesh`, with their values, to what `found` has of the meshes before it. Refused: cells of three
/// dimensions whose shape TAn does not know, lists of corners that contradict each other.
Status addCells(vtkUnstructuredGrid& mesh, const VtkArray& array, const VtkSamples& samples, VtkFindings& found);

/// The points of polygons and alike, or of a mesh, without what joins them.
Result<VtkFindings> pointFindings(vtkDataSet& data, const VtkArray& array, const VtkSamples& samples);

} // namespace tetra
