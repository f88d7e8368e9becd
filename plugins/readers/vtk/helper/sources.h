// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/vtk/helper/provenance.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// A VTK reader with its file, not yet run.
struct VtkSource {
    vtkSmartPointer<vtkAlgorithm> reader;
    /// Switches on what the request asks for, as far as the reader has switches; after UpdateInformation().
    std::function<void()> selectArrays = [] {};
    /// Gives what was read the precision of the file, where VTK has less.
    std::function<void(vtkDataObject&)> refine = [](vtkDataObject&) {};
    /// Adds what of the file as a whole is taken or left out; after the data were read.
    std::function<void(Provenance&)> tell = [](Provenance&) {};
    /// Changes of what was found that the file asks for and VTK leaves out.
    std::function<void(VtkFindings&)> finish = [](VtkFindings&) {};
    std::vector<std::string> untold{"unit"}; ///< FileContents::untold of such files
    bool knowsContents = false;              ///< UpdateInformation() alone tells arrays and sizes
    /// What the headers of a file tell that is so large that its data are not read for it; else nothing.
    std::function<std::optional<FileContents>(const VtkRequest&)> contentsOfHeaders = [](const VtkRequest&) {
        return std::optional<FileContents>();
    };
    /// Adds to the contents what VTK leaves out, such as units.
    std::function<void(FileContents&)> finishContents = [](FileContents&) {};
    /// The times of a source that has already taken the request's step by itself; else empty.
    std::vector<double> times{};
    std::string stepFile{}; ///< in which file that step lies, if each has its own
};

/// The number, from 0, of the step that the request asks for (from 1; 0: the first) among so many. The error says which
/// there are.
Result<std::size_t> stepAsked(const VtkRequest& request, std::size_t steps);

/// The reader for the request's format. The error says what is wrong with the file, for files that no VTK reader should
/// be given.
Result<VtkSource> makeSource(const VtkRequest& request);

} // namespace tetra
