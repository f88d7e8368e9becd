// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <vector>

namespace tetra {

/// What to do about the boundary of a closed set's mesh of irregular data.
struct BoundaryRepair {
    bool isSound = true;              ///< a manifold that does not meet itself
    std::vector<std::uint32_t> sites; ///< else to be added, with all that they need; empty if none are known to help
};

/// Tests the boundary of the mesh of a closed set (C3, S12). In the mesh at the end of a batch the boundary is sound;
/// so two of its triangles can only meet if no such mesh has the tetrahedra of both: one was destroyed in a batch no
/// later than that in which the other was made. Those pairs are tested, exactly, in the positions of the sites. `sites`
/// destroy the older tetrahedron of each pair that meets, as far as they are among the first `known`, which end a
/// batch. `mesh` is as extractSet() gives it. O(tetrahedra) and expected O(b log^2 b) for b faces of the boundary, 100
/// bytes a tetrahedron while it runs. Errors: cancelled.
Result<BoundaryRepair> testBoundary(const Model& model, const ExtractedMesh& mesh, std::uint32_t known,
                                    const Progress& progress);

} // namespace tetra
