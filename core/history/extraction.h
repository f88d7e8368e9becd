// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/history/model.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <cstdint>
#include <span>
#include <string>

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

/// The sizes of a model's meshes at several accuracies, as a file for other programs: one line a level with a line of
/// names before it, numbers under no locale, errors and warpings in % of the value range and of the diagonal.
std::string levelsAsCsv(const Model& model, std::span<const Accuracy> levels);

/// The same as one JSON object, with where the model is from: "model", "source", "builder", "sites", "tetrahedra",
/// "bytes", and "levels", a list of "error", "warping", "sites", "tetrahedra", "reached" and "reached_warping".
std::string levelsAsJson(const Model& model, std::span<const Accuracy> levels);

/// Either, as the name's ending says. Errors: WrongUsage, it is neither .csv nor .json.
Result<std::string> levelsFor(const std::filesystem::path& path, const Model& model, std::span<const Accuracy> levels);

} // namespace tetra
