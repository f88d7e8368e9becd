// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scenes/scene_builder.h"

#include "core/history/whole_elsewhere.h"

#include <tan/query.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <new>
#include <optional>
#include <utility>

namespace tetra {
namespace {

/// A scene is given up for a newer one if it takes longer than this, or much longer than the last one took, so that the
/// picture follows a slider or a focus that is being dragged as quickly as scenes can be made; but never longer than
/// the second.
constexpr auto leastPatience = std::chrono::milliseconds(300);
constexpr auto mostPatience = std::chrono::milliseconds(2500);
constexpr double muchLonger = 1.5;

std::chrono::milliseconds patienceFor(double seconds)
{
    const auto wanted = std::chrono::milliseconds(std::llround(1000 * muchLonger * seconds));
    return std::clamp(wanted, leastPatience, mostPatience);
}

/// A draft on its way is finished before a newer one begins, if it does not take longer.
constexpr auto draftPatience = std::chrono::milliseconds(300);

bool haveSameMesh(const SceneRequest& first, const SceneRequest& second)
{
    return first.model == second.model && first.query == second.query;
}

/// The tetrahedra of the coarsest mesh that there is, wherever the model lies.
std::uint64_t coarsestMesh(const Model& model)
{
    return model.elsewhere() != nullptr ? model.elsewhere()->sizes().meshes.front().tetrahedra
                                        : meshSizeAt(model, {anyError, anyWarping}).tetrahedra;
}

/// Closed sets are found at once, whatever the field; a draft need not be the smallest mesh.
MeshQuery coarserQuery(MeshQuery query, std::uint64_t budget)
{
    query.budget = query.budget ? std::min(*query.budget, budget) : budget;
    query.method = VariableMethod::ClosedSet;
    return query;
}

/// Of the meshes to prepare, the finest first: before window and values each has a quarter of the last one, or there is
/// only the one that is chosen. A mesh that is no coarser is left out; none is asked for with fewer tetrahedra than the
/// coarsest mesh of the model has, which would be refused.
std::vector<MeshQuery> coarserQueries(const MeshQuery& query, const ShownMesh& shown, const MovingQuality& quality,
                                      std::uint64_t coarsest)
{
    std::vector<MeshQuery> queries;
    if (query.range)
        return queries; // no coarser mesh stands for many
    const double whole = static_cast<double>(shown.wholeTetrahedra) / static_cast<double>(shown.tetrahedra);
    switch (quality.kind) {
    case MovingQuality::Kind::FrameRate:
        for (const std::uint64_t size : coarserMeshes(shown.tetrahedra))
            queries.push_back(coarserQuery(query, static_cast<std::uint64_t>(whole * static_cast<double>(size))));
        break;
    case MovingQuality::Kind::Error:
        if (query.error.bounds().minimum < quality.percent) {
            queries.push_back(query);
            queries.back().error = largerOf(query.error, quality.percent);
            queries.back().method = VariableMethod::ClosedSet;
        }
        break;
    case MovingQuality::Kind::Share:
        if (quality.percent < 100)
            queries.push_back(coarserQuery(
                query,
                std::max<std::uint64_t>(1, static_cast<std::uint64_t>(quality.percent / 100 *
                                                                      static_cast<double>(shown.wholeTetrahedra)))));
        break;
    case MovingQuality::Kind::Full: break;
    }
    for (MeshQuery& one : queries)
        if (one.budget)
            one.budget = std::max(*one.budget, coarsest);
    const auto again = std::ranges::unique(queries);
    queries.erase(again.begin(), again.end());
    return queries;
}

} // namespace

SceneBuilder::SceneBuilder(QObject* parent)
    : QObject(parent), patience_(leastPatience), pipeline_(std::make_shared<ScenePipeline>())
{
}

SceneBuilder::~SceneBuilder() = default;

void SceneBuilder::request(SceneRequest request)
{
    setBusy(true);
    job_.submit(
        [this, number = ++newest_, pipeline = pipeline_, request = std::move(request)](const std::stop_token& stop) {
            Made made = make(*pipeline, request, Progress(stop, {}));
            QMetaObject::invokeMethod(
                this, [this, number, made = std::move(made)] { arrived(number, made); }, Qt::QueuedConnection);
        },
        patience_);
}

/// Where the samples that are asked for cannot be had, the mesh is better than nothing.
SceneBuilder::Made SceneBuilder::make(ScenePipeline& pipeline, const SceneRequest& request, const Progress& progress)
{
    Result<BuiltScene> scene = pipeline.make(request, progress);
    if (scene || scene.error().kind == ErrorKind::Cancelled || !asksForSamples(request))
        return {std::move(scene)};
    Result<BuiltScene> ofMesh = pipeline.make(withMesh(request), progress);
    if (!ofMesh)
        return {std::move(ofMesh)};
    return {std::move(ofMesh), scene.error()};
}

std::shared_ptr<const ExtractedMesh> SceneBuilder::mesh() const
{
    return pipeline_->mesh();
}

void SceneBuilder::clear()
{
    cleared_ = newest_;
    last_.reset();
    // The worker gives back the mesh, in its own time.
    job_.submit([pipeline = pipeline_](const std::stop_token&) { pipeline->clear(); });
    setBusy(false);
}

void SceneBuilder::tellMissed(const std::optional<Error>& missed)
{
    const std::string text = missed ? missed->text() : std::string();
    if (text != std::exchange(lastMissed_, text) && missed)
        emit samplesMissed(*missed);
}

void SceneBuilder::arrived(quint64 number, const Made& made)
{
    const Result<BuiltScene>& result = made.scene;
    if (number <= cleared_)
        return;
    if (number == newest_)
        setBusy(false);
    if (result)
        patience_ = patienceFor(result->extractionSeconds + result->sceneSeconds);
    if (result) {
        last_ = *result;
        emit sceneReady(*result);
        tellMissed(made.missed);
        return;
    }
    if (number == newest_)
        last_.reset();
    if (result.error().kind != ErrorKind::Cancelled)
        emit failed(result.error());
}

void SceneBuilder::setBusy(bool busy)
{
    if (busy_ == busy)
        return;
    busy_ = busy;
    emit busyChanged(busy);
}

/// What the worker keeps between two requests: a pipeline for each mesh.
struct DraftBuilder::Pipelines {
    using Tell = std::function<void(std::vector<DraftScene>)>;

    std::optional<SceneRequest> present;                   ///< that the meshes belong to
    MovingQuality quality;                                 ///< likewise
    std::vector<MeshQuery> queries;                        ///< of the meshes, the finest first
    std::vector<std::unique_ptr<ScenePipeline>> pipelines; ///< the coarsest first, as far as they were made
    std::size_t made = 0;                                  ///< of them, so many have had a scene
    ScenePipeline::Extractor extractor = std::make_shared<std::optional<MeshExtractor>>();

    void make(const SceneRequest& request, const ShownMesh& shown, const MovingQuality& wanted,
              const Progress& progress, const Tell& tell);
    void clear();
};

/// What fails or is cancelled leaves fewer drafts: the full scene tells what is wrong.
void DraftBuilder::Pipelines::make(const SceneRequest& request, const ShownMesh& shown, const MovingQuality& wanted,
                                   const Progress& progress, const Tell& tell)
try {
    if (!present || !haveSameMesh(*present, request) || wanted != quality) {
        pipelines.clear();
        made = 0;
        quality = wanted;
        queries = coarserQueries(request.query, shown, quality, coarsestMesh(*request.model));
    }
    present = request;
    std::vector<DraftScene> drafts;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        if (i == pipelines.size())
            pipelines.push_back(std::make_unique<ScenePipeline>(makeCpuBackend(), extractor));
        const SceneRequest coarser = withQuery(withMesh(request), queries[queries.size() - 1 - i]);
        const auto built = pipelines[i]->make(coarser, progress);
        if (!built || built->mesh.tetrahedra == 0 || built->mesh.tetrahedra >= shown.tetrahedra)
            return;
        drafts.insert(drafts.begin(), {built->scene, built->mesh.tetrahedra});
        const bool isNew = i == made;
        made = std::max(made, i + 1);
        if (isNew || i + 1 == queries.size())
            tell(drafts);
    }
} catch (const std::bad_alloc&) {
    clear();
}

void DraftBuilder::Pipelines::clear()
{
    pipelines.clear();
    made = 0;
    present.reset();
    extractor->reset();
}

DraftBuilder::DraftBuilder(QObject* parent) : QObject(parent), pipelines_(std::make_shared<Pipelines>()) {}

DraftBuilder::~DraftBuilder() = default;

void DraftBuilder::setQuality(const MovingQuality& quality)
{
    if (quality == std::exchange(quality_, quality) || !last_)
        return;
    cleared_ = newest_;
    emit draftsReady({});
    submit(*last_);
}

void DraftBuilder::request(const SceneRequest& request, const ShownMesh& shown)
{
    if (shown.tetrahedra == 0)
        return clear();
    const bool isSameMesh = last_ && haveSameMesh(*last_, request);
    const bool isKnown = last_ && haveSameScene(*last_, request);
    shown_ = shown;
    if (!isSameMesh) {
        cleared_ = newest_; // drafts of another mesh, on their way yet
        emit draftsReady({});
    }
    if (!isKnown)
        submit(request);
}

void DraftBuilder::requestAppearance(const SceneRequest& request)
{
    if (last_ && haveSameMesh(*last_, request))
        submit(request);
}

void DraftBuilder::submit(const SceneRequest& request)
{
    last_ = request;
    job_.submit(
        [this, request, shown = shown_, quality = quality_, pipelines = pipelines_,
         number = ++newest_](const std::stop_token& stop) {
            pipelines->make(request, shown, quality, Progress(stop, {}),
                            [this, number](std::vector<DraftScene> drafts) {
                                QMetaObject::invokeMethod(
                                    this,
                                    [this, number, drafts = std::move(drafts)] {
                                        if (number > cleared_)
                                            emit draftsReady(drafts);
                                    },
                                    Qt::QueuedConnection);
                            });
        },
        draftPatience);
}

void DraftBuilder::clear()
{
    last_.reset();
    cleared_ = newest_;
    job_.submit([pipelines = pipelines_](const std::stop_token&) { pipelines->clear(); });
}

} // namespace tetra
