// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace tetra {

/// A dataset out of which a file consists, with its name in the file.
struct VtkLeaf {
    std::string name;
    vtkSmartPointer<vtkDataSet> data;
};

/// All datasets with points, in the file's order; one if the data are no blocks.
std::vector<VtkLeaf> leavesOf(vtkDataObject& data);

/// The leaf called `wanted`, by name or number from 1. The error lists them.
Result<VtkLeaf> chooseLeaf(const std::vector<VtkLeaf>& leaves, const std::string& wanted);

} // namespace tetra
