// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

namespace tetra {

/// What a plane, the end of a half-space, has in common with a mesh: the cut through it, and each face that lies in the
/// plane once, on whichever side of it the mesh goes on. With the field's values; triangles wind, and normals look, out
/// of the half-space. O(vertices + tetrahedra), twice that of cutByPlane() where vertices lie in the plane. Errors:
/// those of cutByPlane().
Result<TriangleMesh> planeSlice(const TetrahedralMesh& mesh, const HalfSpace& plane, const Progress& progress);

} // namespace tetra
