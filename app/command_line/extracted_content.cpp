// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/extracted_content.h"

#include <tan/query.h>

namespace tetra {

MeshContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                      const std::optional<double>& errorInSpace)
{
    MeshContent content;
    content.positions = mesh.mesh.positions;
    content.tetrahedra = mesh.mesh.tetrahedra;
    content.pointArrays = {{valueArrayName(model.description().valueName), std::span<const float>(mesh.mesh.values)}};
    if (query.range)
        content.cellArrays = {{"birth_error", std::span<const float>(mesh.birthErrors)},
                              {"death_error", std::span<const float>(mesh.deathErrors)}};
    content.facts = meshFacts(model, query, mesh, errorInSpace);
    return content;
}

} // namespace tetra
