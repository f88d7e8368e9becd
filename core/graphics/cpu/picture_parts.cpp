// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/cpu/picture_parts.h"

namespace tetra {

std::vector<SampleRectangle> picturePartsOf(int width, int height, int tileSide)
{
    const int side = largestPartSide / tileSide * tileSide;
    std::vector<SampleRectangle> parts;
    for (int top = 0; top < height; top += side)
        for (int left = 0; left < width; left += side)
            parts.push_back({left, top, std::min(left + side, width), std::min(top + side, height)});
    return parts;
}

} // namespace tetra
