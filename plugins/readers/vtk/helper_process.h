// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <chrono>
#include <filesystem>
#include <variant>

namespace tetra {

using VtkAnswer = std::variant<VtkFindings, FileContents>;

/// Where the helper program of this plugin lies: beside the plugin's own file.
std::filesystem::path vtkHelperBesidePlugin();

/// Runs the helper program on a request and waits for its answer. VTK runs in a process of its own because its readers
/// break down on many a damaged file, print, and take a tenth of a second to load: whatever happens there is an Error
/// here. Cancelling ends the process at once. It limits its own memory and time (process_limits.h); it is ended if for
/// `idle` it neither worked nor said anything, as on a disk that does not answer. Errors: the helper's own; a limit
/// that it met; VTK is not installed (with what to install); no memory or files to start it; it crashed. Any thread.
Result<VtkAnswer> askVtkHelper(const std::filesystem::path& helper, VtkRequest request, const Progress& progress,
                               std::chrono::milliseconds idle = std::chrono::minutes(10));

} // namespace tetra
