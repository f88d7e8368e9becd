// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/picture_form.h"
#include "ui/viewport/scene_showing.h"
#include "ui/workbench/workbench.h"

namespace tetra {

/// What is seen, as a picture without a target; with what tools keep, but not their handles.
PictureOrder pictureOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings);

/// The session's film, without a target.
FilmOrder filmOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings);

} // namespace tetra
