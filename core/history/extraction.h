// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/history/model.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <cstdint>

namespace tetra {

/// No warping is larger, so asking for it asks for nothing.
inline constexpr double anyWarping = 100;

/// The accuracy pair of a query (R14, R7), in the units that people see. Convex models have no warping.
struct Accuracy {
    double error = 0;            ///< % of the value range
    double warping = anyWarping; ///< % of the bounding box's diagonal
};

/// The size of a mesh, known without extracting it (R26).
struct MeshSize {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    /// What the running key of this mesh bounds: % of the value range, and % of the diagonal (0 without warping).
    double error = 0;
    double warping = 0;
};

/// The first mesh at least as accurate as asked (first passage, S1), as a prefix of the sites: O(log sites).
/// Asked for more than the model has, it gives the whole model. Of a damaged file anything, and Model::checkIntact()
/// says so afterwards.
MeshSize meshSizeAt(const Model& model, const Accuracy& accuracy);

/// The same for the mesh of the first `sites` sites, which end a batch.
MeshSize meshSizeOf(const Model& model, std::uint32_t sites);

/// Extracts the mesh of the first `sites` sites (R14, R15): vertex v of the mesh is site v. The last of them must end
/// its group (Model::groupGoesOn()), as it does for every meshSizeAt(). Reads the prefix of the file that those sites
/// created and nothing else; O(tetrahedra that they created). The buffers of `reuse`, if any, are used again. Errors: a
/// damaged or inconsistent file, sites that have no mesh, cancelled.
Result<TetrahedralMesh> extractPrefix(const Model& model, std::uint32_t sites, const Progress& progress = {},
                                      TetrahedralMesh reuse = {});

} // namespace tetra
