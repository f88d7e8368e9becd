// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/extracted_content.h"

#include <tan/query.h>

#include <algorithm>

namespace tetra {
namespace {

/// A number where the field is one, else its text.
void addField(MeshFacts& facts, const std::string& name, const ErrorField& field, double scale)
{
    if (field.isConstant())
        facts.emplace_back(name, keptPercent(field.bounds().minimum, scale));
    else
        facts.emplace_back(name + "_field", toText(field));
}

} // namespace

MeshFacts meshFacts(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    MeshFacts facts = {{"model", model.path().filename().string()}, {"source", model.description().sourceName}};
    if (query.range) {
        // Of a model at a server the sizes are known only about.
        const auto errorOf = [&model](const Accuracy& end) {
            return model.elsewhere() != nullptr ? end.error : meshSizeAt(model, end).error;
        };
        const double one = errorOf(query.range->one), other = errorOf(query.range->other);
        facts.emplace_back("coarsest_error", std::max(one, other));
        facts.emplace_back("finest_error", std::min(one, other));
        return facts;
    }
    addField(facts, "error", query.error, mesh.scale);
    if (model.description().warpingWeight > 0)
        addField(facts, "warping", query.warping, mesh.scale);
    facts.emplace_back("error_scale", mesh.scale);
    return facts;
}

MeshContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    MeshContent content;
    content.positions = mesh.mesh.positions;
    content.tetrahedra = mesh.mesh.tetrahedra;
    content.pointArrays = {{"value", std::span<const float>(mesh.mesh.values)}};
    if (query.range)
        content.cellArrays = {{"birth_error", std::span<const float>(mesh.birthErrors)},
                              {"death_error", std::span<const float>(mesh.deathErrors)}};
    content.facts = meshFacts(model, query, mesh);
    return content;
}

} // namespace tetra
