// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/scene_pipeline.h"

#include "core/render/volume/volume_mesh.h"
#include "core/view/lens.h"
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/scene_parameters.h"

#include <chrono>
#include <new>
#include <utility>
#include <variant>

namespace tetra {
namespace {

constexpr int histogramParts = 256;

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The edges of faulty cells, seen before any colours and by all eyes: black lines with a yellow core, which few
/// surfaces have.
void addOutlines(Scene& scene, const std::vector<FaultyCell>& cells)
{
    constexpr float coreWidth = 2, rimWidth = 5;
    LineSet core{.points = {}, .segments = {}, .colour = distinctColour(6), .width = coreWidth};
    for (const FaultyCell& cell : cells)
        for (const std::array<Eigen::Vector3d, 2>& edge : edgesOf(cell)) {
            const auto first = static_cast<std::uint32_t>(core.points.size());
            core.segments.push_back({first, first + 1});
            for (const Eigen::Vector3d& end : edge) {
                core.points.push_back(end);
                scene.bounds.extend(end); // one may lie outside of the mesh that is left
            }
        }
    LineSet rim = core;
    rim.colour = {0, 0, 0};
    rim.width = rimWidth;
    scene.drawables.push_back({.id = "faulty-cells/rim", .shape = std::move(rim), .overlay = true});
    scene.drawables.push_back({.id = "faulty-cells", .shape = std::move(core), .overlay = true});
}

Error outOfMemory()
{
    return {ErrorKind::OutOfResource,
            Message::say("There is not enough memory for the mesh at this accuracy. Choose a coarser one, or close "
                         "other programs.")};
}

} // namespace

std::uint64_t triangleCount(const Scene& scene)
{
    std::uint64_t count = 0;
    for (const Surface* surface : shapesOf<Surface>(scene))
        count += surface->mesh ? surface->mesh->triangles.size() : 0;
    return count;
}

bool hasVolume(const Scene& scene)
{
    return !shapesOf<Volume>(scene).empty() || !shapesOf<FocusVolume>(scene).empty();
}

void scaleLines(Scene& scene, double factor)
{
    for (Drawable& drawable : scene.drawables)
        if (auto* lines = std::get_if<LineSet>(&drawable.shape))
            lines->width = static_cast<float>(lines->width * factor);
}

bool haveSameScene(const SceneRequest& one, const SceneRequest& other)
{
    if (one.model != other.model || one.renderer != other.renderer || !(one.query == other.query) ||
        one.values != other.values || one.faultyCells != other.faultyCells ||
        asksForSamples(one) != asksForSamples(other))
        return false;
    return one.renderer == nullptr || !one.renderer->needs().view ||
           (one.camera == other.camera && one.width == other.width && one.height == other.height);
}

SceneRequest withQuery(SceneRequest request, MeshQuery query)
{
    const auto transfer = request.values.find(transferId);
    if (request.usualTransfer && transfer != request.values.end())
        transfer->second = request.usualTransfer(query);
    request.query = std::move(query);
    return request;
}

SceneRequest lensScene(const LensOrder& order, const LensPicture& place, const Camera& camera)
{
    SceneRequest request = withMesh(order.scene);
    request.camera = camera;
    request.width = place.width;
    request.height = place.height;
    request.query = lensQuery(request.query, order.lens.error, seenInLens(place, camera), *request.model);
    return request;
}

/// The meshes that a request needs: one, or with a renderer that blends a focus two.
struct ScenePipeline::NeededMeshes {
    MeshQuery query;
    std::optional<TwoResolutions> focus; ///< then `query` is the one outside

    explicit NeededMeshes(const SceneRequest& request) : query(request.query)
    {
        if (request.renderer->needs().focusMesh)
            focus = twoResolutions(request.query);
        if (focus)
            query = focus->outside;
    }
};

void ScenePipeline::setMesh(std::shared_ptr<const ExtractedMesh> next)
{
    const std::lock_guard lock(mutex_);
    mesh_.swap(next); // the last one is freed when nobody waits any more
}

bool ScenePipeline::has(const SceneRequest& request, const NeededMeshes& needed) const
{
    return mesh_ && model_ == request.model && query_ == needed.query;
}

MeshExtractor& ScenePipeline::extractorOf(const std::shared_ptr<const Model>& model)
{
    if (!*extractor_ || (*extractor_)->model() != model)
        extractor_->emplace(model);
    return **extractor_;
}

/// Lets go of the last mesh first, so that the extractor can use its memory again.
Status ScenePipeline::extract(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress)
{
    session_.reset();
    setMesh(nullptr);
    fineMesh_.reset();
    focus_.reset();
    auto extracted = extractorOf(request.model).extract(needed.query, progress);
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    setMesh(*std::move(extracted));
    query_ = needed.query;
    model_ = request.model;
    const ValueRange range = request.model->description().range;
    histogram_ = std::make_shared<const ValueHistogram>(
        valueHistogram(mesh_->mesh.values, range.minimum, range.maximum, histogramParts));
    meshBounds_.setEmpty();
    if (needed.query.window || !needed.query.values.empty())
        for (const auto& position : mesh_->mesh.positions)
            meshBounds_.extend(position);
    logarithmic_.reset();
    if (range.minimum > 0)
        logarithmic_ = std::make_shared<const ValueHistogram>(
            logarithmicHistogram(mesh_->mesh.values, range.minimum, range.maximum, histogramParts));
    return {};
}

/// The mesh in the focus, if there is one to blend.
Status ScenePipeline::extractFine(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress)
{
    session_.reset();
    fineMesh_.reset();
    focus_.reset();
    if (!needed.focus)
        return {};
    auto extracted = extractorOf(request.model).extract(needed.focus->inside, progress);
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    fineMesh_ = *std::move(extracted);
    focus_ = needed.focus;
    return {};
}

void ScenePipeline::open(const SceneRequest& request, const NeededMeshes& needed)
{
    RendererMeshes meshes{.mesh = {mesh_, &mesh_->mesh}, .bounds = request.model->description().bounds};
    if (needed.focus)
        meshes.focus = FocusMesh{{fineMesh_, &fineMesh_->mesh}, needed.focus->regions};
    session_ = request.renderer->open(meshes);
    renderer_ = request.renderer;
}

ShownMesh ScenePipeline::shownMesh(const Model& model, const MeshQuery& asked) const
{
    ShownMesh shown{.query = asked,
                    .vertices = mesh_->mesh.positions.size(),
                    .tetrahedra = mesh_->mesh.tetrahedra.size(),
                    .wholeSites = mesh_->wholeSites,
                    .wholeTetrahedra = mesh_->wholeTetrahedra,
                    .keptSites = mesh_->keptSites,
                    .keptTetrahedra = mesh_->keptTetrahedra,
                    .isBlended = fineMesh_ != nullptr,
                    .scale = mesh_->scale,
                    .errorMeaning = errorMeaning(model.description(), asked),
                    .logarithms = logarithmsOf(model.description()),
                    .bounds = meshBounds_,
                    .histogram = histogram_,
                    .logarithmicHistogram = logarithmic_};
    if (fineMesh_) {
        shown.vertices += fineMesh_->mesh.positions.size();
        shown.tetrahedra += fineMesh_->mesh.tetrahedra.size();
        shown.keptSites += fineMesh_->keptSites;
        shown.keptTetrahedra += fineMesh_->keptTetrahedra;
    }
    return shown;
}

Status ScenePipeline::outlineFaultyCells(BuiltScene& built)
{
    if (outlinedModel_ != built.model) {
        outlinedModel_.reset();
        auto cells = faultyCells(*built.model);
        if (!cells)
            return cells.error();
        std::erase_if(*cells, [](const FaultyCell& cell) { return cell.corners.empty(); });
        outlined_ = *std::move(cells);
        outlinedModel_ = built.model;
    }
    built.faultyCells = outlined_.size();
    if (outlined_.empty())
        return {};
    const auto scene = std::make_shared<Scene>(*built.scene);
    addOutlines(*scene, outlined_);
    built.scene = scene;
    return {};
}

namespace {

/// What is asked for in place of the mesh.
ShownField wantedFieldOf(const SceneRequest& request)
{
    const auto found = request.values.find(shownId);
    const auto* shown = found != request.values.end() ? std::get_if<std::string>(&found->second) : nullptr;
    if (shown == nullptr || !request.samples)
        return ShownField::Mesh;
    return *shown == shownData         ? ShownField::Data
           : *shown == shownDifference ? ShownField::Difference
                                       : ShownField::Mesh;
}

/// What of a query samples cannot answer, which are everywhere alike.
MeshInstead meshInstead(const MeshQuery& query)
{
    return query.range                 ? MeshInstead::OfRange
           : query.window              ? MeshInstead::OfWindow
           : !query.values.empty()     ? MeshInstead::OfValues
           : !query.error.isConstant() ? MeshInstead::OfFocus
                                       : MeshInstead::No;
}

/// What is to be seen in place of the mesh; the mesh where no samples can stand for it.
ShownField shownFieldOf(const SceneRequest& request)
{
    return meshInstead(request.query) == MeshInstead::No ? wantedFieldOf(request) : ShownField::Mesh;
}

} // namespace

bool asksForSamples(const SceneRequest& request)
{
    return shownFieldOf(request) != ShownField::Mesh;
}

SceneRequest withMesh(SceneRequest request)
{
    request.samples = nullptr;
    return request;
}

Status ScenePipeline::showSamples(const SceneRequest& request, BuiltScene& built, const Progress& progress)
{
    const ShownField shown = shownFieldOf(request);
    const auto place = std::ranges::find_if(built.scene->drawables, [](const Drawable& drawable) {
        const auto* volume = std::get_if<Volume>(&drawable.shape);
        return volume != nullptr && !volume->model;
    });
    if (shown == ShownField::Mesh || place == built.scene->drawables.end())
        return {};
    if (sampledModel_ != request.model) {
        samples_.reset();
        auto dataset = request.samples(*request.model, progress.part(0, 0.5));
        if (!dataset)
            return dataset.error();
        samples_.emplace(*std::move(dataset));
        sampledModel_ = request.model;
    }
    const Volume& volume = std::get<Volume>(place->shape);
    auto samples = samples_->update(volume.transfer->segments, volume.shaded, progress.part(0.5, 1));
    if (!samples)
        return samples.error();
    samples->fullGradient = volume.fullGradient;
    auto data = std::make_shared<Scene>(*built.scene);
    data->drawables[static_cast<std::size_t>(place - built.scene->drawables.begin())].shape = *samples;
    if (shown == ShownField::Difference) {
        const auto difference = std::make_shared<Scene>(*built.scene);
        difference->reference = std::move(data);
        built.scene = difference;
    } else {
        built.scene = std::move(data);
    }
    built.mesh.shown = shown;
    return {};
}

Result<BuiltScene> ScenePipeline::make(const SceneRequest& request, const Progress& progress)
try {
    if (built_ && haveSameScene(last_, request))
        return *built_;
    built_.reset();
    BuiltScene built;
    built.model = request.model;
    const auto start = std::chrono::steady_clock::now();
    const NeededMeshes needed(request);
    if (!has(request, needed)) {
        if (const Status extracted = extract(request, needed, progress.part(0, 0.3)); !extracted)
            return extracted.error();
        built.extractionSeconds = secondsSince(start);
    }
    if (focus_ != needed.focus) {
        if (const Status extracted = extractFine(request, needed, progress.part(0.3, 0.5)); !extracted)
            return extracted.error();
        built.extractionSeconds = secondsSince(start);
    }
    if (!session_ || renderer_ != request.renderer)
        open(request, needed);
    ParameterValues values = request.values;
    if (const auto boundary = values.find(boundaryId); mesh_->overlaps && boundary != values.end())
        boundary->second = std::string(boundaryOff); // tetrahedra over each other have none
    const double prepared = shownFieldOf(request) == ShownField::Mesh ? 1 : 0.7;
    auto scene =
        session_->prepare({values, request.camera, request.width, request.height}, progress.part(0.5, prepared));
    if (!scene) {
        if (scene.error().kind == ErrorKind::OutOfResource)
            clear();
        return scene.error();
    }
    if (mesh_->overlaps && hasVolume(**scene))
        return Error{
            ErrorKind::WrongUsage,
            Message::say("A range of accuracies has overlapping tetrahedra, so their volume cannot be drawn. Choose "
                         "isosurfaces, or limits of appearance and disappearance that leave one mesh.")};
    built.scene = *std::move(scene);
    if (request.faultyCells)
        if (const Status outlined = outlineFaultyCells(built); !outlined)
            return outlined.error();
    built.mesh = shownMesh(*request.model, request.query);
    if (wantedFieldOf(request) != ShownField::Mesh)
        built.mesh.instead = meshInstead(request.query);
    if (const Status shown = showSamples(request, built, progress.part(prepared, 1)); !shown)
        return shown.error();
    built.triangles = triangleCount(*built.scene);
    built.sceneSeconds = secondsSince(start) - built.extractionSeconds;
    last_ = request;
    built_ = built;
    built_->extractionSeconds = built_->sceneSeconds = 0; // if it is asked for again
    return built;
} catch (const std::bad_alloc&) {
    clear();
    return outOfMemory();
}

Result<Picture> ScenePipeline::draw(const PictureOrder& order, bool withDepth, const Progress& progress)
{
    PictureOptions options;
    options.width = order.width;
    options.height = order.height;
    options.part = order.part;
    options.background = order.background;
    options.transparentBackground = order.transparent;
    options.samplesPerAxis = order.samplesPerAxis;
    options.threads = order.threads;
    options.depth = withDepth;
    Scene scene = order.scene ? *order.scene : Scene();
    scaleLines(scene, order.lineScale);
    return backend_->render(scene, order.camera, options, progress);
}

Result<DrawnLens> ScenePipeline::drawLens(const PictureOrder& order, const Progress& progress)
{
    const LensState& lens = order.lens->lens;
    DrawnLens drawn{.shape = lens.shape, .place = lensPicture(lens, order.width, order.height)};
    const auto built = make(lensScene(*order.lens, drawn.place, order.camera), progress.part(0, 0.5));
    if (!built)
        return built.error();
    PictureOrder enlarged = order;
    enlarged.scene = built->scene;
    enlarged.width = drawn.place.width;
    enlarged.height = drawn.place.height;
    enlarged.part = drawn.place.part;
    auto picture = draw(enlarged, false, progress.part(0.5, 1));
    if (!picture)
        return picture.error();
    drawn.content = *std::move(picture);
    drawn.tetrahedra = built->mesh.tetrahedra;
    return drawn;
}

Result<Picture> ScenePipeline::finish(const PictureOrder& order, Picture picture, const Progress& progress)
{
    if (!order.lens || !order.lens->lens.isOn() || !order.lens->scene.model || order.lens->scene.renderer == nullptr)
        return finishedPicture(order, std::move(picture));
    const auto lens = drawLens(order, progress);
    if (!lens)
        return lens.error();
    return finishedPicture(order, std::move(picture), *lens);
}

std::shared_ptr<const ExtractedMesh> ScenePipeline::mesh() const
{
    const std::lock_guard lock(mutex_);
    return mesh_;
}

void ScenePipeline::clear()
{
    session_.reset();
    setMesh(nullptr);
    fineMesh_.reset();
    focus_.reset();
    extractor_->reset();
    model_.reset();
    outlinedModel_.reset();
    outlined_.clear();
    sampledModel_.reset();
    samples_.reset();
    built_.reset();
    last_ = {};
}

Result<Picture> drawPicture(const PictureOrder& order, const Progress& progress)
{
    ScenePipeline pipeline;
    auto picture = pipeline.draw(order, false, progress.part(0, order.lens ? 0.5 : 1));
    if (!picture)
        return picture.error();
    return pipeline.finish(order, *std::move(picture), progress.part(0.5, 1));
}

Result<Picture> drawPicture(PictureOrder order, const SceneRequest& scene, const Progress& progress)
{
    ScenePipeline pipeline;
    const auto built = pipeline.make(scene, progress.part(0, 0.5));
    if (!built)
        return built.error();
    order.scene = built->scene;
    auto picture = pipeline.draw(order, false, progress.part(0.5, order.lens ? 0.7 : 1));
    if (!picture)
        return picture.error();
    return pipeline.finish(order, *std::move(picture), progress.part(0.7, 1));
}

} // namespace tetra
