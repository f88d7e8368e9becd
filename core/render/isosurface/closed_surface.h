// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/boundary.h"

#include <tan/base.h>
#include <tan/mesh.h>

namespace tetra {

/// On which side of an isovalue the solid lies that a closed surface goes around.
enum class SolidSide { Above, Below };

/// What all closed surfaces of a mesh have in common.
struct ClosingBasis {
    BoundaryFaces boundary;
    Buffer<Eigen::Vector3f> gradients; ///< those of a mesh without slope, as these surfaces have no normals
};

/// O(vertices + tetrahedra). Errors: cancelled, not enough memory, more than largestAdjacentCellCount tetrahedra.
TAN_INTERNAL Result<ClosingBasis> closingBasis(const TetrahedralMesh& mesh, const Progress& progress = {});

/// The surface of a solid: the isosurface of the mesh, as extractIsosurface() places it, with what of the boundary of
/// the mesh has values on the solid's side, so that it has no opening where the isosurface meets the boundary. Vertices
/// are shared where the two meet. Triangles wind so that their front looks out of the solid; there are no normals, as
/// there are sharp edges. Where the solid touches itself, four triangles meet at an edge. O(vertices + tetrahedra).
/// Errors: cancelled, not enough memory, arguments that do not belong together.
TAN_INTERNAL Result<TriangleMesh> closedIsosurface(const TetrahedralMesh& mesh, const ClosingBasis& basis,
                                                   double isovalue, SolidSide side, const Progress& progress = {});

/// Of a mesh that no other surface is made of. Errors: those of closingBasis(), too.
TAN_INTERNAL Result<TriangleMesh> closedIsosurface(const TetrahedralMesh& mesh, double isovalue, SolidSide side,
                                                   const Progress& progress = {});

} // namespace tetra
