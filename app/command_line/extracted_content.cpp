// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/extracted_content.h"

#include <tan/query.h>

#include <utility>

namespace tetra {

ExtractedContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                           const std::optional<double>& errorInSpace)
{
    const ModelDescription& description = model.description();
    ValueArrays values = valueArrays(description.valueName, holdsLogarithms(description.parameters), mesh.mesh.values);
    MeshContent content;
    content.positions = mesh.mesh.positions;
    content.tetrahedra = mesh.mesh.tetrahedra;
    content.pointArrays = std::move(values.arrays);
    if (query.range)
        content.cellArrays = {{"birth_error", std::span<const float>(mesh.birthErrors)},
                              {"death_error", std::span<const float>(mesh.deathErrors)}};
    content.facts = meshFacts(model, query, mesh, errorInSpace);
    return {std::move(content), std::move(values.kept)};
}

} // namespace tetra
