// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/region_handles.h"

#include <QColor>

class QPainter;

namespace tetra {

/// How a region is painted over the picture.
struct RegionLook {
    QColor colour;
    QColor rim;
    bool selected = false;
    bool dragged = false; ///< then the picture has no outline of it
    std::optional<RegionHandle> hovered;
};

/// Of outline and handles, to be told apart and seen on the ground of the picture.
QColor regionColour(RegionKind kind, const QColor& ground);

/// The whole outline, faintly, as surfaces hide parts of it in the picture; and the handles.
void paintRegion(QPainter& painter, const ViewProjection& projection, const MovableRegion& place,
                 const std::vector<RegionHandle>& handles, const RegionLook& look);

/// The line that a centre is held to, `half` long to either side.
void paintAxis(QPainter& painter, const ViewProjection& projection, const Eigen::Vector3d& centre, int axis,
               double half, const QColor& colour);

} // namespace tetra
