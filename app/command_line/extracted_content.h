// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/query/history_part.h"
#include "plugins/api/written_content.h"

#include <tan/query.h>

#include <vector>

namespace tetra {

/// A mesh for a file: the array "value" of its vertices, and what it was extracted from and how. Points into `mesh`.
MeshContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh);

/// From which error a tetrahedron lives, and from which it does not any more, in % of the value range: it is in the
/// mesh of an error e if death <= e < birth. The first tetrahedra have the birth infinity, the last ones the death 0.
struct Lives {
    std::vector<float> births;
    std::vector<float> deaths;
};
Lives livesOf(const Model& model, const HistoryPart& part);

/// Tetrahedra of many meshes for a file: as above, with the arrays "birth_error" and "death_error" of the tetrahedra.
MeshContent contentOf(const Model& model, const HistoryPart& part, const Lives& lives);

} // namespace tetra
