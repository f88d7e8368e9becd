// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cut_cells.h"
#include "core/mesh/boundary.h"

#include <tan/base.h>

namespace tetra {

/// Takes away tetrahedra that are there twice. Returns how many. `faces` are those of `cut`, before and after.
std::uint64_t removeDuplicates(CutCells& cut, MeshFaces& faces);

/// Makes the boundary a manifold: where parts of the mesh touch in an edge or a point only, the part with the fewest
/// tetrahedra there loses them; where two holes touch in a point, they are joined. Takes away no more than `most`
/// tetrahedra: then what is left still has such places. Returns how many went. Positive tetrahedra that match. Rounds
/// of O(tetrahedra), each takes something away. `faces` are those of `cut`, before and
/// after. Cancelled: ends early.
std::uint64_t removePinches(CutCells& cut, MeshFaces& faces, std::uint64_t most, const Progress& progress);

} // namespace tetra
