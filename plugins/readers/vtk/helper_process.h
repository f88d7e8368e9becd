// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "plugins/api/reader.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <filesystem>
#include <variant>

namespace tetra {

using VtkAnswer = std::variant<VtkFindings, FileContents>;

/// Where the helper program of this plugin lies: beside the plugin's own file.
std::filesystem::path vtkHelperBesidePlugin();

/// Runs the helper program on a request and waits for its answer. VTK runs in a process of its own because its readers
/// break down on many a damaged file, print, and take a tenth of a second to load: whatever happens there is an Error
/// here. Cancelling ends the process at once. Errors: the helper's own; VTK is not installed (with what to install);
/// the helper crashed. Any thread.
Result<VtkAnswer> askVtkHelper(const std::filesystem::path& helper, VtkRequest request, const Progress& progress);

} // namespace tetra
