// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/dataset.h"

namespace tetra {

Eigen::AlignedBox3d Dataset::bounds() const
{
    if (!positions)
        return lattice.bounds();
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : *positions)
        box.extend(position);
    return box;
}

} // namespace tetra
