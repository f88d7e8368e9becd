// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <tan/model.h>

namespace tetra {

/// What is known of a model before there is a mesh of it: its range and its box.
FieldExtent roughExtentOf(const Model& model);
/// What defaults follow from: the model's range and box, and by a coarse mesh of it how the values share the volume, so
/// that transfer functions to begin with show what is rare, and where the data have a surface. The same for window and
/// command line. Takes some milliseconds: not for the GUI thread.
FieldExtent extentOf(const Model& model);

} // namespace tetra
