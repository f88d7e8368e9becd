// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/mesh_saving.h"

#include "core/base/guarded.h"
#include "core/history/error_meaning.h"
#include "core/history/query_words.h"
#include "core/picture/mesh_remarks.h"
#include "core/verify/verify_mesh.h"
#include "plugins/host/value_arrays.h"

#include <tan/query.h>
#include <tan/render.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
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

MeshFacts factsOf(const Model& model, const MeshQuery& query, double scale,
                  const std::optional<double>& errorInSpace = {}, const std::optional<Accuracy>& reached = {})
{
    MeshFacts facts = {{"model", model.path().filename().string()}, {"dataset", model.description().sourceName}};
    if (!model.description().valueName.empty())
        facts.emplace_back("array", model.description().valueName);
    if (holdsLogarithms(model.description().parameters))
        facts.emplace_back(std::string(scaleFact), std::string(logarithmFact));
    if (!model.description().lengthUnit.empty())
        facts.emplace_back("unit", model.description().lengthUnit);
    if (query.range) {
        facts.emplace_back("smallest error in percent", std::min(query.range->one.error, query.range->other.error));
        facts.emplace_back("largest error in percent", std::max(query.range->one.error, query.range->other.error));
        addErrorKind(facts, errorMeaning(model.description(), query), errorInSpace);
        return facts;
    }
    addErrors(facts, "error in percent", query.error, scale);
    if (model.description().warpingWeight > 0)
        addErrors(facts, "warping in percent", query.warping, scale);
    if (reached) {
        facts.emplace_back("reached error in percent", reached->error);
        if (model.description().warpingWeight > 0)
            facts.emplace_back("reached warping in percent", reached->warping);
    }
    addErrorKind(facts, errorMeaning(model.description(), query), errorInSpace);
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

Error noSurface()
{
    return {ErrorKind::WrongUsage, Message::say("There is no surface to save: add an isovalue, or show one.")};
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
    const ModelDescription& description = order.model->description();
    ValueArrays values =
        valueArrays(description.valueName, holdsLogarithms(description.parameters), extracted.mesh.values);
    MeshContent content{extracted.mesh.positions, extracted.mesh.tetrahedra, std::move(values.arrays), {}, {}};
    if (order.model->elsewhere() == nullptr) // a server does not tell them
        content.pointArrays.push_back({"site", std::span<const std::uint32_t>(extracted.sites)});
    if (!extracted.birthErrors.empty())
        content.cellArrays = {{"birth_error", std::span<const float>(extracted.birthErrors)},
                              {"death_error", std::span<const float>(extracted.deathErrors)}};
    const auto measured = measureInSpace(*order.model, order.query, extracted, progress.part(0, 0.3));
    if (!measured)
        return measured.error();
    content.facts = factsOf(*order.model, order.query, extracted.scale,
                            *measured ? std::optional((*measured)->largest) : std::nullopt, extracted.reached);
    if (const Status right = order.model->confirm(progress.withCallback({})); !right)
        return right.error();
    const auto saved = saveMesh(host, content, order.target, {}, progress.part(0.3, 1));
    if (!saved)
        return saved.error();
    FileRemarks remarks =
        meshRemarks(description, order.query, extracted, false, !isSurfaceFileOnly(host, order.target));
    std::ranges::copy(*saved, std::back_inserter(remarks));
    return remarks;
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
        return noSurface();
    const Model& model = *order.scene.model;
    content.facts = factsOf(model, order.scene.query, order.built->mesh.scale, order.built->mesh.errorInSpace);
    if (const Status right = model.confirm(progress.withCallback({})); !right)
        return right.error();
    return saveSurface(host, content, order.target, {}, progress);
}

namespace {

/// What the deviation cannot be measured of.
Status checkMeasurable(const SolidOrder& order)
{
    const MeshQuery& query = order.mesh.query;
    if (!order.deviation)
        return {};
    if (order.mesh.model->elsewhere() != nullptr)
        return Error{ErrorKind::WrongUsage, Message::say("The deviation is measured from the finest mesh, which stays "
                                                         "at the server. Save without it, or download the model.")};
    if (!query.values.empty() || (query.window && query.window->border != WindowBorder::Clipped))
        return Error{ErrorKind::WrongUsage,
                     Message::say("The deviation is that of whole surfaces. Show all values, and cut off what lies "
                                  "outside the crop box, or save without it.")};
    return {};
}

Result<Message> makeAndWriteSolids(PluginHost& host, const SolidOrder& order, const Progress& progress)
{
    constexpr double extracted = 0.3, made = 0.5, measured = 0.9;
    const Model& model = *order.mesh.model;
    std::vector<Isovalue> shown;
    std::ranges::copy_if(order.isovalues, std::back_inserter(shown), &Isovalue::visible);
    if (shown.empty())
        return noSurface();
    if (const Status writable = checkWritable(host, WrittenContent::Surface, order.mesh.target); !writable)
        return writable.error();
    if (order.mesh.query.range)
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "The tetrahedra of a range of errors overlap, so they make no solid. Show the mesh of one error.")};
    if (const Status measurable = checkMeasurable(order); !measurable)
        return measurable.error();
    MeshExtractor extractor(order.mesh.model);
    std::shared_ptr<const ExtractedMesh> mesh = order.mesh.mesh;
    if (!mesh) {
        auto found = extractor.extract(order.mesh.query, progress.part(0, extracted));
        if (!found)
            return found.error();
        mesh = *std::move(found);
    }
    std::vector<double> values;
    std::ranges::transform(shown, std::back_inserter(values), &Isovalue::value);
    auto surfaces = makeSurfaces(mesh->mesh, values, order.making, progress.part(extracted, made));
    if (!surfaces)
        return surfaces.error();
    if (order.deviation)
        if (const Status held =
                measureDeviations(extractor, order.mesh.query, order.making, *surfaces, progress.part(made, measured));
            !held)
            return held.error();
    SurfaceContent content{.title = "isosurfaces", .valueName = "isovalue", .parts = {}, .facts = {}};
    Message report;
    for (std::size_t i = 0; i < surfaces->size(); ++i) {
        const MadeSurface& surface = (*surfaces)[i];
        content.parts.push_back({.name = "isovalue " + formatNumber(surface.value),
                                 .positions = surface.mesh.positions,
                                 .normals = surface.mesh.normals,
                                 .triangles = surface.mesh.triangles,
                                 .values = static_cast<float>(surface.value),
                                 .colour = {shown[i].red, shown[i].green, shown[i].blue, shown[i].opacity}});
        const Message shape = shapeText(surface, model.description().lengthUnit);
        report = report.empty() ? shape : Message::say("%1 %2", report, shape);
        if (surface.hasNoCounterpart)
            report = Message::say("%1 %2", report, missingDeviationText(surface));
    }
    content.facts = factsOf(model, order.mesh.query, mesh->scale);
    addDeviation(*surfaces, content.facts);
    if (const Status right = model.confirm(progress.withCallback({})); !right)
        return right.error();
    const auto saved =
        saveSurface(host, content, order.mesh.target, {}, progress.part(order.deviation ? measured : made, 1));
    if (!saved)
        return saved.error();
    for (const Message& remark : *saved)
        report = Message::say("%1 %2", report, remark);
    return report;
}

} // namespace

Result<Message> writeSolids(PluginHost& host, const SolidOrder& order, const Progress& progress)
{
    return guarded(Message::marked(
                       "Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh."),
                   [&] { return makeAndWriteSolids(host, order, progress); });
}

} // namespace tetra
