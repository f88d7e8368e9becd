// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/render_backend.h"

namespace tetra {

/// In pixels. Numbers of samples, the one after the last included, have 16 bits where a volume is drawn.
inline constexpr int largestPictureSide = 32767;

/// An error if no back end can make such a picture.
Status checkOptions(const PictureOptions& options);

} // namespace tetra
