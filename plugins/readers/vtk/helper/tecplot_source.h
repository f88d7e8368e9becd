// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// The zones of a Tecplot text (tecplot_text.h) as blocks of VTK. The errors are those of readTecplot().
Result<VtkSource> makeTecplotSource(const std::string& path);

} // namespace tetra
