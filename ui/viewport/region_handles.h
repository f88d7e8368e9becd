// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/view_projection.h"

#include <tan/render.h>
#include <tan/view.h>

#include <optional>
#include <vector>

namespace tetra {

/// What a region is grabbed by: its centre moves it; the faces of a box move one side, those of a sphere its radius.
struct RegionHandle {
    enum class Kind { Centre, Face, Radius };
    Kind kind = Kind::Centre;
    int axis = 0;    ///< of a face
    double side = 1; ///< of a face: -1 or 1
    Eigen::Vector3d place{0, 0, 0};
    /// The same one, wherever it has been moved to.
    bool isSameAs(const RegionHandle& other) const noexcept
    {
        return kind == other.kind && axis == other.axis && side == other.side;
    }
};

Eigen::Vector3d centreOf(const MovableRegion& region);
MovableRegion moved(const MovableRegion& region, const Eigen::Vector3d& by);

/// The handles that are of use in this view: the centre; the faces of a box but those that are moved towards the viewer
/// or away; four places around a sphere, in the plane of the view.
std::vector<RegionHandle> handlesOf(const MovableRegion& region, const ViewProjection& projection);

/// The handle that is seen nearest to a place in the picture, none farther than `reach` pixels.
std::optional<RegionHandle> handleAt(const std::vector<RegionHandle>& handles, const ViewProjection& projection,
                                     QPointF pixel, double reach);

/// What the edges of the box are, or three great circles of the sphere.
LineSet outlineOf(const MovableRegion& region, const Colour& colour, float width);

/// How a drag is held.
struct DragRule {
    bool restrained = false; ///< the centre along the axis that fits best; a face together with the opposite one
    std::optional<int> axis; ///< the centre along this axis: 0, 1 or 2
    double least = 0;        ///< no edge and no radius becomes smaller
};

/// A region on its way with a handle that follows the pointer. A value: the drag goes from where it began, so that
/// nothing adds up.
struct RegionDrag {
    MovableRegion start;
    RegionHandle handle;
    ViewProjection projection;
    QPointF from;

    MovableRegion at(QPointF pointer, const DragRule& rule) const;
};

} // namespace tetra
