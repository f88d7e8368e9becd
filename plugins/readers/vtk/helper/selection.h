// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/helper/leaves.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <cstddef>
#include <vector>

namespace tetra {

/// Which parts of a file are read, and which array of them.
struct VtkSelection {
    std::vector<std::size_t> parts; ///< numbers of leaves: one, or several irregular meshes that are joined
    std::vector<std::size_t> partsWithoutArray{}; ///< irregular meshes that would be joined if they had the array
    VtkArray array;                               ///< of the first of `parts`
    bool joinsMeshes = false;
};

/// The part that the request names; else all irregular meshes that have the array of the first one with one, if the
/// first volume is such a mesh; else the first volume, or the first part. Errors: no points; no such part or array.
Result<VtkSelection> selectParts(const std::vector<VtkLeaf>& leaves, const VtkRequest& request);

/// Whether it has cells of three dimensions, or is a grid.
bool isVolume(vtkDataSet& data);

/// The array of the same name, of points or of cells as that one; nothing if there is none.
std::optional<VtkArray> sameArray(vtkDataSet& data, const VtkArray& wanted);

} // namespace tetra
