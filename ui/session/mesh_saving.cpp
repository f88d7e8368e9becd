// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/mesh_saving.h"

#include "core/mesh/files/mesh_file.h"
#include "core/model/queries/mesh_extractor.h"

namespace tetra {
namespace {

using Facts = decltype(MeshContent::facts);

void addErrors(Facts& facts, const std::string& name, const ErrorField& field, double scale)
{
    const ValueRange bounds = field.bounds();
    if (bounds.minimum == bounds.maximum) {
        facts.emplace_back(name, keptPercent(bounds.maximum, scale));
    } else {
        facts.emplace_back("smallest " + name, keptPercent(bounds.minimum, scale));
        facts.emplace_back("largest " + name, keptPercent(bounds.maximum, scale));
    }
}

} // namespace

Status writeMesh(const MeshOrder& order, const Progress& progress)
{
    if (!order.mesh) {
        auto made = MeshExtractor(order.model).extract(order.query, progress.part(0, 0.5));
        if (!made)
            return made.error();
        return writeMesh({order.model, *made, order.query, order.target}, progress.part(0.5, 1));
    }
    const ExtractedMesh& extracted = *order.mesh;
    MeshContent content{extracted.mesh.positions, extracted.mesh.tetrahedra, {}, {}, {}};
    content.pointArrays.push_back({"value", std::span<const float>(extracted.mesh.values)});
    content.pointArrays.push_back({"site", std::span<const std::uint32_t>(extracted.sites)});
    content.facts.emplace_back("model", order.model->path().filename().string());
    content.facts.emplace_back("dataset", order.model->description().sourceName);
    addErrors(content.facts, "error in percent", order.query.error, extracted.scale);
    if (order.model->description().warpingWeight > 0)
        addErrors(content.facts, "warping in percent", order.query.warping, extracted.scale);
    return writeMeshFile(order.target, content, progress);
}

} // namespace tetra
