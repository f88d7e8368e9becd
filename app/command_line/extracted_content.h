// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/serve/mesh_facts.h"
#include "plugins/api/written_content.h"
#include "plugins/host/value_arrays.h"

#include <tan/query.h>

#include <optional>

namespace tetra {

/// A mesh for a file, and what it points into beside that mesh.
struct ExtractedContent {
    MeshContent content;
    std::shared_ptr<const Buffer<float>> kept{};
};

/// The valueArrays() of the vertices; of a range of accuracies also "birth_error" and "death_error" of the tetrahedra;
/// and meshFacts(). Points into `mesh`.
ExtractedContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                           const std::optional<double>& errorInSpace = {});

} // namespace tetra
