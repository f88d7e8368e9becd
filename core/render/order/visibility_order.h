// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_adjacency.h"
#include "core/render/order/cycle_cutting.h"
#include "core/render/order/face_classification.h"
#include "core/render/order/topological_sort.h"

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <span>

namespace tetra {

/// Orders all cells by adjacency: a cell comes after its neighbours across the faces that look to the eye (P. Williams,
/// "Visibility ordering meshed polyhedra", ACM Transactions on Graphics 11, 1992) and after the fronts of `relations`.
/// For a convex domain and cells that are not inverted that is exact for every ray; for others it is exact for the rays
/// whose gaps `relations` holds. What hides itself in a circle is cut (orderCycles()); it costs nothing where there is
/// no such circle.
///
/// O(cells + relations), several times faster where the mesh is in spatial order. Facing is on all threads of the
/// current arena. Then two take cells at the same time, one from the front, the other from the back, until each has
/// half of them; what remains in the middle, because others were taken by both, is taken from the front. The same order
/// with any number of threads. May throw std::bad_alloc.
VisibilityOrder orderByAdjacency(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency, const EyePoint& eye,
                                 std::span<const CellRelation> relations = {});

/// How far a visibility order made for one camera is from fitting another: the largest angle in degrees, at the centre
/// and the corners of `bounds`, between the directions to both eyes. 0 if the eye stayed (in orthographic views, if it
/// only moved along or across them): then the order of a convex domain is exact still. With small angles few faces are
/// passed by the eye, and only their cells are in wrong order. 180 if the projection changed, or the eye moved inside.
double orderDrift(const Eigen::AlignedBox3d& bounds, const Camera& from, const Camera& to);

} // namespace tetra
