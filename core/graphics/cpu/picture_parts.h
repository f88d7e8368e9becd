// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/sample_rectangle.h"

#include <vector>

namespace tetra {

/// Pictures with more samples a side than this are drawn in parts, so that what is kept for the tiles at one time, and
/// the coordinates in them, stay bounded. Twice what the largest screens have.
inline constexpr int largestPartSide = 8192;

/// A picture of `width` x `height` samples in parts, row by row, whose sides but the last are multiples of `tileSide`.
std::vector<SampleRectangle> picturePartsOf(int width, int height, int tileSide);

} // namespace tetra
