// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/history/model.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// Some consecutive stars of a history: that of site `firstSite` + i is [offsets[i], offsets[i + 1]), within the
/// arrays.
struct Stars {
    std::span<const std::array<std::uint32_t, 3>> otherSites; ///< of the whole history, as are the destroyers
    std::span<const std::uint32_t> destroyers;
    std::uint32_t firstSite = 0;
    std::span<const std::uint64_t> offsets;
};

struct AliveScan {
    std::array<std::uint32_t, 4>* end; ///< behind the last tetrahedron that was found
    bool sitesComeBefore;              ///< whether in every tetrahedron the other sites come before the creator
};

/// Copies the tetrahedra that are alive in the mesh of the first `sites` sites to `out`, creator first, in order. `out`
/// has room for all tetrahedra of the stars and aliveScanOverrun more: which ones are alive follows no pattern that a
/// processor could predict, so every one is written, and the next one goes over it if it was dead. Reads every number
/// once: what it returns holds even if another program changes the file meanwhile.
using AliveScanFunction = AliveScan (*)(const Stars& stars, std::uint32_t sites, std::array<std::uint32_t, 4>* out);
inline constexpr std::uint64_t aliveScanOverrun = 4;

struct AliveScanVariant {
    std::string_view name;
    AliveScanFunction scan;
};

/// The variants that this processor can run, the fastest first; all do the same.
std::span<const AliveScanVariant> aliveScans();

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
