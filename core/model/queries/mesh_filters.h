// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/queries/mesh_query.h"

#include <span>

namespace tetra {

/// Keeps the tetrahedra that can contain a value of one of the ranges, ends included, or all if there are no ranges;
/// vertices stay as they are. Error: cancelled; what is left of the mesh is then good for nothing.
Status keepValues(TetrahedralMesh& mesh, std::span<const ValueRange> ranges, const Progress& progress = {});

/// Keeps what the window asks for. Cutting is exact in its combinatorics: a vertex on the border is within, equal edges
/// are cut at the same place, and the quadrilaterals of neighbours get the same diagonal, so the result conforms. It
/// adds vertices behind the others, with values interpolated along their edges, and never makes a tetrahedron without
/// volume from one with volume, but for rounding: a window that cuts is rounded to floats. A window whose least corner
/// is not the least is empty. Gives how many of the mesh's tetrahedra are kept, whole or in part. Errors: cancelled,
/// out of memory; what is left of the mesh is then good for nothing.
Result<std::uint64_t> keepWindow(TetrahedralMesh& mesh, const Window& window, const Progress& progress = {});

/// Removes vertices that no tetrahedron uses, keeping the order of the others, and renumbers. Vertices behind the last
/// one of `sites`, which cutting made, get ExtractedMesh::noSite; the others are counted as `keptSites`.
void dropUnusedVertices(ExtractedMesh& mesh);

} // namespace tetra
