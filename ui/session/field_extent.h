// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/model.h"
#include "plugins/api/renderer.h"

namespace tetra {

/// What renderers can know of a model before there is a mesh of it: its range and its box.
FieldExtent roughExtentOf(const Model& model);
/// The same and how the values share the volume, by a coarse mesh of the model, so that transfer functions to begin
/// with show what is rare. Takes some milliseconds: not for the GUI thread.
FieldExtent extentOf(const Model& model);

} // namespace tetra
