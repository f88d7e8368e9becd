// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/mesh_saving.h"

#include <tan/query.h>
#include <tan/render.h>

#include <algorithm>
#include <span>
#include <variant>

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

MeshFacts factsOf(const Model& model, const MeshQuery& query, double scale)
{
    MeshFacts facts = {{"model", model.path().filename().string()}, {"dataset", model.description().sourceName}};
    if (query.range) {
        facts.emplace_back("smallest error in percent", std::min(query.range->one.error, query.range->other.error));
    if (!model.description().valueName.empty())
        facts.emplace_back("array", model.description().valueName);
        facts.emplace_back("largest error in percent", std::max(query.range->one.error, query.range->other.error));
        return facts;
    }
    addErrors(facts, "error in percent", query.error, scale);
    if (model.description().warpingWeight > 0)
        addErrors(facts, "warping in percent", query.warping, scale);
    return facts;
}

SurfacePart partOf(const Drawable& drawable, const Surface& surface)
{
    SurfacePart part{.name = drawable.label,
                     .positions = surface.mesh->positions,
                     .normals = surface.mesh->normals,
                     .triangles = surface.mesh->triangles,
                     .colour = {surface.colour.red, surface.colour.green, surface.colour.blue, surface.opacity},
                     .colours = surface.mesh->colours};
    if (drawable.value)
        part.values = static_cast<float>(*drawable.value);
    else if (!surface.mesh->values.empty())
        part.values = std::span<const float>(surface.mesh->values);
    return part;
}

/// The surface of a drawable that is to be saved; null of any other.
const Surface* savedSurface(const Drawable& drawable)
{
    const auto* surface = std::get_if<Surface>(&drawable.shape);
    return surface != nullptr && surface->mesh && drawable.saved ? surface : nullptr;
}

/// Points into the scene.
SurfaceContent contentOf(const Scene& scene, const ModelDescription& of)
{
    SurfaceContent content{.title = "isosurfaces", .valueName = "isovalue", .parts = {}, .facts = {}};
    for (const Drawable& drawable : scene.drawables) {
        const Surface* surface = savedSurface(drawable);
        if (surface == nullptr)
            continue;
        content.parts.push_back(partOf(drawable, *surface));
        if (!drawable.value) {
            content.title = "surfaces";
            content.valueName = valueArrayName(of.valueName);
        }
    }
    return content;
}

} // namespace

bool hasSurfaceToSave(const Scene& scene)
{
    return std::ranges::any_of(scene.drawables,
                               [](const Drawable& drawable) { return savedSurface(drawable) != nullptr; });
}

Result<FileRemarks> writeMesh(PluginHost& host, const MeshOrder& order, const Progress& progress)
{
    if (const Status writable = checkWritable(host, WrittenContent::Mesh, order.target); !writable)
        return writable.error();
    if (!order.mesh) {
        auto made = MeshExtractor(order.model).extract(order.query, progress.part(0, 0.5));
        if (!made)
            return made.error();
        return writeMesh(host, {order.model, *made, order.query, order.target}, progress.part(0.5, 1));
    }
    const ExtractedMesh& extracted = *order.mesh;
    MeshContent content{extracted.mesh.positions, extracted.mesh.tetrahedra, {}, {}, {}};
    content.pointArrays.push_back(
        {valueArrayName(order.model->description().valueName), std::span<const float>(extracted.mesh.values)});
    if (order.model->elsewhere() == nullptr) // a server does not tell them
        content.pointArrays.push_back({"site", std::span<const std::uint32_t>(extracted.sites)});
    if (!extracted.birthErrors.empty())
        content.cellArrays = {{"birth_error", std::span<const float>(extracted.birthErrors)},
                              {"death_error", std::span<const float>(extracted.deathErrors)}};
    content.facts = factsOf(*order.model, order.query, extracted.scale);
    if (const Status right = order.model->confirm(progress.withCallback({})); !right)
        return right.error();
    return saveMesh(host, content, order.target, {}, progress);
}

Result<FileRemarks> writeSurfaces(PluginHost& host, const SurfaceOrder& order, const Progress& progress)
{
    constexpr double made = 0.7;
    if (const Status writable = checkWritable(host, WrittenContent::Surface, order.target); !writable)
        return writable.error();
    if (!order.built) {
        auto built = ScenePipeline().make(order.scene, progress.part(0, made));
        if (!built)
            return built.error();
        return writeSurfaces(host, {order.scene, *std::move(built), order.target}, progress.part(made, 1));
    }
    SurfaceContent content = contentOf(*order.built->scene, order.scene.model->description());
    if (content.parts.empty())
        return Error{ErrorKind::WrongUsage, Message::say("There is no surface to save: add an isovalue, or show one.")};
    const Model& model = *order.scene.model;
    content.facts = factsOf(model, order.scene.query, order.built->mesh.scale);
    if (const Status right = model.confirm(progress.withCallback({})); !right)
        return right.error();
    return saveSurface(host, content, order.target, {}, progress);
}

} // namespace tetra
