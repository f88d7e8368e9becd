// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/sources.h"

namespace tetra {

/// Readers of images, slices and stacks of them: TIFF, DICOM. TIFF: the numbered files beside
/// the given one are the slices, unless it holds several itself. DICOM: all the files of its folder.
Result<VtkSource> makeImageSource(const VtkRequest& request);

} // namespace tetra
