// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"
#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// checkBeforeVtk() of the files that a list (series_list.h) names for the step that the request asks for. Errors name
/// the file.
Result<CheckedFile> checkSeries(const VtkRequest& request);

/// The files of that step, read; several as blocks.
Result<VtkSource> makeSeriesSource(const VtkRequest& request);

} // namespace tetra
