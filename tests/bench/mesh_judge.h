// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/plain_mesh.h"

#include <cstdint>

namespace tetra {

/// What a decimated mesh is worth, whoever made it. Errors in % of the original's value range: at each of its vertices
/// the difference to the interpolation in the mesh, outside to that at the nearest place of the mesh's boundary (R5).
struct MeshJudgement {
    double largestError = 0;
    double meanError = 0;
    std::uint64_t outside = 0;  ///< vertices of the original that no tetrahedron contains
    double farthestOutside = 0; ///< from the mesh's boundary, in % of the original's diagonal
    std::uint64_t inverted = 0; ///< tetrahedra that are not positive
    double overshoot = 0;       ///< how far its values leave the original range, in % of that
};

/// `original`'s tetrahedra are positive, as are those of `mesh` where nothing is inverted. Slow, and in doubles.
MeshJudgement judge(const PlainMesh& original, const PlainMesh& mesh);

} // namespace tetra
