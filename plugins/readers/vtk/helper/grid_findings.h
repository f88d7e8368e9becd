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
    std::array<std::uint32_t, 3> size{};
    bool onLattice = false;
    Eigen::Vector3d spacing{1, 1, 1}; ///< of a lattice, of either sign, along the grid's own axes
    Eigen::Vector3d origin{0, 0, 0};  ///< of its first point
    std::array<int, 3> axes{0, 1, 2}; ///< along which axis of space each axis of the grid runs
};

/// Nothing if `data` is no grid. A lattice are image data along the axes of space, also exchanged or backwards, and
/// rectilinear grids of equal steps.
std::optional<VtkGrid> gridOf(vtkDataSet& data);

/// The findings of a grid: a lattice brought to ascending axes, or a grid with its positions. Values of cells become
/// the mean of the cells around each point. Holes are left to withHoles().
Result<VtkFindings> gridFindings(vtkDataSet& data, const VtkGrid& grid, const VtkArray& array, VtkSamples samples);

} // namespace tetra
