// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/scene.h"

namespace tetra {

LineSet boxOutline(const Eigen::AlignedBox3d& box, const Colour& colour, float width)
{
    LineSet lines;
    lines.colour = colour;
    lines.width = width;
    if (box.isEmpty())
        return lines;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        lines.points.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)).cast<float>());
        for (std::uint32_t axis = 1; axis < 8; axis *= 2)
            if ((corner & axis) == 0)
                lines.segments.push_back({corner, corner | axis});
    }
    return lines;
}

} // namespace tetra
