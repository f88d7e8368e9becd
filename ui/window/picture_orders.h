// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/picture_form.h"
#include "ui/workbench/workbench.h"

namespace tetra {

class Viewport;

/// The pixels of the view on the screen.
QSize pixelsOf(const Viewport& viewport);

/// What is seen, as a picture without a target.
PictureOrder pictureOrder(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings);

/// The session's film, without a target.
FilmOrder filmOrder(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings);

} // namespace tetra
