// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// Readers of VTK's XML formats, by the type that the file says it is.
Result<VtkSource> makeXmlSource(const VtkRequest& request);

} // namespace tetra
