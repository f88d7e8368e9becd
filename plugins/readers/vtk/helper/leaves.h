// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace tetra {

/// A dataset out of which a file consists, with its name in the file; if several have the same, with the blocks in
/// which it lies, "solid/internalMesh".
struct VtkLeaf {
    std::string name;
    vtkSmartPointer<vtkDataSet> data;
};

/// All datasets with points, in the file's order; one if the data are no blocks.
std::vector<VtkLeaf> leavesOf(vtkDataObject& data);

/// The number, from 0, of the leaf called `wanted`, by name or number from 1. The error lists them.
Result<std::size_t> chooseLeaf(const std::vector<VtkLeaf>& leaves, const std::string& wanted);

} // namespace tetra
