// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"

namespace tetra {

/// Fills in the normals of `surface` that are zero: the mean of the normals of the triangles, weighted by area; a
/// vertex without one gets +z. O(vertices + triangles), one thread.
void fillNormalsFromTriangles(TriangleMesh& surface);

} // namespace tetra
