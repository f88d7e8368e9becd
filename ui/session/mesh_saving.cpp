// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/mesh_saving.h"

#include "core/base/text.h"
#include "plugins/host/file_saving.h"

#include <tan/query.h>
#include <tan/render.h>

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

void addErrors(MeshFacts& facts, const std::string& name, const ErrorField& field, double scale)
{
    const ValueRange bounds = field.bounds();
    if (bounds.minimum == bounds.maximum) {
        facts.emplace_back(name, keptPercent(bounds.maximum, scale));
    } else {
        facts.emplace_back("smallest " + name, keptPercent(bounds.minimum, scale));
        facts.emplace_back("largest " + name, keptPercent(bounds.maximum, scale));
    }
}

MeshFacts factsOf(const MeshOrder& order)
{
    MeshFacts facts = {{"model", order.model->path().filename().string()},
                       {"dataset", order.model->description().sourceName}};
    addErrors(facts, "error in percent", order.query.error, order.mesh->scale);
    if (order.model->description().warpingWeight > 0)
        addErrors(facts, "warping in percent", order.query.warping, order.mesh->scale);
    return facts;
}

SurfacePart partOf(const Surface& surface, double isovalue)
{
    return {.name = "isovalue " + formatNumber(isovalue),
            .positions = surface.mesh->positions,
            .normals = surface.mesh->normals,
            .triangles = surface.mesh->triangles,
            .values = static_cast<float>(isovalue),
            .colour = {surface.colour.red, surface.colour.green, surface.colour.blue, surface.opacity}};
}

} // namespace

Status writeMesh(PluginHost& host, const MeshOrder& order, const Progress& progress)
{
    if (!order.mesh) {
        auto made = MeshExtractor(order.model).extract(order.query, progress.part(0, 0.5));
        if (!made)
            return made.error();
        return writeMesh(host, {order.model, *made, order.query, order.target}, progress.part(0.5, 1));
    }
    const ExtractedMesh& extracted = *order.mesh;
    MeshContent content{extracted.mesh.positions, extracted.mesh.tetrahedra, {}, {}, {}};
    content.pointArrays.push_back({"value", std::span<const float>(extracted.mesh.values)});
    content.pointArrays.push_back({"site", std::span<const std::uint32_t>(extracted.sites)});
    content.facts = factsOf(order);
    if (Status right = order.model->confirm(progress.withCallback({})); !right)
        return right;
    return saveMesh(host, content, order.target, {}, progress);
}

Status writeSurfaces(PluginHost& host, const SurfaceOrder& order, const Progress& progress)
{
    constexpr double extracted = 0.4;
    constexpr double found = 0.7;
    if (Status writable = checkWritable(host, WrittenContent::Surface, order.mesh.target); !writable)
        return writable;
    std::vector<Isovalue> visible;
    std::ranges::copy_if(order.isovalues, std::back_inserter(visible), &Isovalue::visible);
    if (visible.empty())
        return Error{ErrorKind::WrongUsage, Message::say("There is no surface to save: add an isovalue, or show one.")};
    if (!order.mesh.mesh) {
        auto made = MeshExtractor(order.mesh.model).extract(order.mesh.query, progress.part(0, extracted));
        if (!made)
            return made.error();
        SurfaceOrder whole = order;
        whole.mesh.mesh = *made;
        return writeSurfaces(host, whole, progress.part(extracted, 1));
    }
    const std::shared_ptr<const TetrahedralMesh> mesh(order.mesh.mesh, &order.mesh.mesh->mesh);
    const auto surfaces = IsosurfaceCache(mesh).update(visible, progress.part(0, found));
    if (!surfaces)
        return surfaces.error();
    SurfaceContent content{.title = "isosurfaces", .valueName = "isovalue", .parts = {}, .facts = factsOf(order.mesh)};
    for (std::size_t index = 0; index < surfaces->size(); ++index)
        content.parts.push_back(partOf((*surfaces)[index], visible[index].value));
    if (Status right = order.mesh.model->confirm(progress.withCallback({})); !right)
        return right;
    return saveSurface(host, content, order.mesh.target, {}, progress.part(found, 1));
}

} // namespace tetra
