// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/extracted_content.h"

#include <tan/query.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

MeshContent contentOf(const Model& model, const TetrahedralMesh& mesh)
{
    MeshContent content;
    content.positions = mesh.positions;
    content.tetrahedra = mesh.tetrahedra;
    content.pointArrays = {{"value", std::span<const float>(mesh.values)}};
    content.facts = {{"model", model.path().filename().string()}, {"source", model.description().sourceName}};
    return content;
}

/// A number where the field is one, else its text.
void addField(MeshContent& content, const std::string& name, const ErrorField& field, double scale)
{
    if (field.isConstant())
        content.facts.emplace_back(name, keptPercent(field.bounds().minimum, scale));
    else
        content.facts.emplace_back(name + "_field", toText(field));
}

} // namespace

MeshContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    MeshContent content = contentOf(model, mesh.mesh);
    addField(content, "error", query.error, mesh.scale);
    if (model.description().warpingWeight > 0)
        addField(content, "warping", query.warping, mesh.scale);
    content.facts.emplace_back("error_scale", mesh.scale);
    return content;
}

Lives livesOf(const Model& model, const HistoryPart& part)
{
    model.check(model.runningKeys()); // what it finds is known to checkIntact()
    const double extent = model.description().range.extent();
    const auto error = [&](std::uint32_t sites) {
        if (sites == Model::never)
            return 0.0F;
        const float key = model.runningKeys()[sites - 1]; // what the mesh without the last of them keeps
        return std::isinf(key) ? key : static_cast<float>(extent > 0 ? 100 * static_cast<double>(key) / extent : 0);
    };
    Lives lives{std::vector<float>(part.births.size()), std::vector<float>(part.deaths.size())};
    std::ranges::transform(part.births, lives.births.begin(), error);
    std::ranges::transform(part.deaths, lives.deaths.begin(), error);
    return lives;
}

MeshContent contentOf(const Model& model, const HistoryPart& part, const Lives& lives)
{
    MeshContent content = contentOf(model, part.mesh);
    content.cellArrays = {{"birth_error", std::span<const float>(lives.births)},
                          {"death_error", std::span<const float>(lives.deaths)}};
    content.facts.emplace_back("coarsest_error", part.coarse.error);
    content.facts.emplace_back("finest_error", part.fine.error);
    return content;
}

} // namespace tetra
