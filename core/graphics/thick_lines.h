// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "core/graphics/view_transform.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace tetra {

/// A line as a rectangle that faces the eye: four corners in clip space, in order around it.
using LineQuad = std::array<Eigen::Vector4d, 4>;

/// The visible segments of `lines` as rectangles `width` samples wide, at least one. The ends reach half a width
/// further, so that lines that meet close their corner. Both back ends draw these, since OpenGL's own lines may be one
/// pixel wide only. O(segments). May throw std::bad_alloc.
std::vector<LineQuad> thickLines(const LineSet& lines, const ViewTransform& transform, double width);

} // namespace tetra
