// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// The zones of a Tecplot text (tecplot_text.h) as blocks of VTK, of the time step that the request asks for. The
/// errors are those of readTecplot(), or say that there is no such step.
Result<VtkSource> makeTecplotSource(const VtkRequest& request);

} // namespace tetra
