// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/segment_crossing.h"

#include "core/cells/cell_orientation.h"

namespace tetra {

using Eigen::Vector3d;

Crossing crossingOf(const Vector3d& from, const Vector3d& to, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    const int atFrom = orientation(a, b, c, from), atTo = orientation(a, b, c, to);
    if (atTo == 0)
        return Crossing::Unclear;
    if (atFrom == atTo || atFrom == 0)
        return Crossing::None;
    const int ab = orientation(from, to, a, b), bc = orientation(from, to, b, c), ca = orientation(from, to, c, a);
    const bool negative = ab < 0 || bc < 0 || ca<0, positive = ab> 0 || bc > 0 || ca > 0;
    if (negative && positive)
        return Crossing::None;
    if (ab == 0 || bc == 0 || ca == 0)
        return Crossing::Unclear;
    return atTo > 0 ? Crossing::Leaving : Crossing::Entering;
}

} // namespace tetra
