// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/animation/turntable.h"

#include <cmath>
#include <numbers>

namespace tetra {

Camera turntableCamera(const Camera& start, const Turntable& turntable, int frame)
{
    if (frame == 0)
        return start;
    const double part = static_cast<double>(frame) / turntable.frames;
    if (turntable.axis == Turntable::Axis::Vertical)
        return turned(start, turntable.degrees * part, 0);
    return turned(start, 0, turntable.degrees / 2 * std::sin(2 * std::numbers::pi * part));
}

} // namespace tetra
