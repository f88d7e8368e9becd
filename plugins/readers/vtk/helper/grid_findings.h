// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <vtkDataSet.h>

#include <optional>

namespace tetra {

/// The points of a grid: of image data, a rectilinear or a structured grid.
struct VtkGrid {
    Lattice lattice{.size = {0, 0, 0}}; ///< its size, and if it is one where it lies
    bool onLattice = false;
};

/// Nothing if `data` is no grid. Lattices are image data, whatever their directions, and rectilinear grids of equal
/// steps, of either sign.
std::optional<VtkGrid> gridOf(vtkDataSet& data);

/// The findings of a grid, in the order of its points: a lattice in its frame, or a grid with its positions. Values of
/// cells become the mean of the cells around each point. Holes are left to withHoles().
Result<VtkFindings> gridFindings(vtkDataSet& data, const VtkGrid& grid, const VtkArray& array, VtkSamples samples);

} // namespace tetra
