// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

namespace tetra {

/// A VTK reader with its file, not yet run.
struct VtkSource {
    vtkSmartPointer<vtkAlgorithm> reader;
    /// Switches on what the request asks for, as far as the reader has switches; after UpdateInformation().
    std::function<void()> selectArrays = [] {};
    /// Changes of what was found that the file asks for and VTK leaves out.
    std::function<void(VtkFindings&)> finish = [](VtkFindings&) {};
    /// The same of what it holds.
    std::function<void(FileContents&)> finishContents = [](FileContents&) {};
    std::vector<std::string> untold{"unit"}; ///< FileContents::untold of such files
    bool knowsContents = false;              ///< UpdateInformation() alone tells arrays and sizes
};

/// The reader for the request's format. The error says what is wrong with the file, for files that no VTK reader should
/// be given.
Result<VtkSource> makeSource(const VtkRequest& request);

} // namespace tetra
