// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/tiles.h"

#include <algorithm>

namespace tetra {

SampleRectangle TileGrid::tile(std::size_t index) const noexcept
{
    const int left = static_cast<int>(index % static_cast<std::size_t>(columns())) * side;
    const int top = static_cast<int>(index / static_cast<std::size_t>(columns())) * side;
    return {left, top, std::min(left + side, width), std::min(top + side, height)};
}

} // namespace tetra
