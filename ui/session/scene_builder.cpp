// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/scene_builder.h"

#include "core/model/queries/mesh_extractor.h"
#include "core/model/queries/two_resolutions.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <new>
#include <optional>

namespace tetra {
namespace {

/// A scene is given up for a newer one if it takes longer than this, or much longer than the last one took, so that the
/// picture follows a slider or a focus that is being dragged as quickly as scenes can be made; but never longer than
/// the second.
constexpr auto leastPatience = std::chrono::milliseconds(300);
constexpr auto mostPatience = std::chrono::milliseconds(2500);
constexpr double muchLonger = 1.5;
constexpr int histogramParts = 256;

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::chrono::milliseconds patienceFor(double seconds)
{
    const auto wanted = std::chrono::milliseconds(std::llround(1000 * muchLonger * seconds));
    return std::clamp(wanted, leastPatience, mostPatience);
}

Error outOfMemory()
{
    return {ErrorKind::OutOfResource,
            "There is not enough memory for the mesh at this accuracy. Choose a coarser one, or "
            "close other programs."};
}

} // namespace

/// The meshes that a request needs: one, or with a renderer that blends a focus two.
struct NeededMeshes {
    MeshQuery query;
    std::optional<TwoResolutions> focus; ///< then `query` is the one outside

    explicit NeededMeshes(const SceneRequest& request) : query(request.query)
    {
        if (request.renderer->blendsFocus())
            focus = twoResolutions(request.query);
        if (focus)
            query = focus->outside;
    }
};

/// What the worker keeps between two requests. Touched by the worker only, but for the mesh.
struct SceneBuilder::Workshop {
    std::optional<MeshExtractor> extractor;
    const Renderer* renderer = nullptr;
    std::optional<MeshQuery> query;                ///< that the mesh answers
    std::optional<TwoResolutions> focus;           ///< that the session blends; none if it does not
    std::shared_ptr<const ExtractedMesh> fineMesh; ///< in the focus
    std::unique_ptr<RendererSession> session;
    std::shared_ptr<const ValueHistogram> histogram; ///< of the mesh
    std::shared_ptr<const ValueHistogram> logarithmic;
    std::mutex mutex; ///< guards the next one
    std::shared_ptr<const ExtractedMesh> mesh;

    void setMesh(std::shared_ptr<const ExtractedMesh> next);
    bool has(const SceneRequest& request, const NeededMeshes& needed) const;
    Status extract(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress);
    Status extractFine(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress);
    void open(const SceneRequest& request, const NeededMeshes& needed);
    Result<BuiltScene> make(const SceneRequest& request, const Progress& progress);
    void clear();
};

void SceneBuilder::Workshop::setMesh(std::shared_ptr<const ExtractedMesh> next)
{
    const std::lock_guard lock(mutex);
    mesh = std::move(next);
}

bool SceneBuilder::Workshop::has(const SceneRequest& request, const NeededMeshes& needed) const
{
    return mesh && extractor && extractor->model() == request.model && query == needed.query;
}

/// Lets go of the last mesh first, so that the extractor can use its memory again.
Status SceneBuilder::Workshop::extract(const SceneRequest& request, const NeededMeshes& needed,
                                       const Progress& progress)
{
    session.reset();
    setMesh(nullptr);
    fineMesh.reset();
    focus.reset();
    if (!extractor || extractor->model() != request.model)
        extractor.emplace(request.model);
    auto extracted = extractor->extract(needed.query, progress);
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    setMesh(*std::move(extracted));
    query = needed.query;
    const ValueRange range = request.model->description().range;
    histogram = std::make_shared<const ValueHistogram>(
        valueHistogram(mesh->mesh.values, range.minimum, range.maximum, histogramParts));
    logarithmic.reset();
    if (range.minimum > 0)
        logarithmic = std::make_shared<const ValueHistogram>(
            logarithmicHistogram(mesh->mesh.values, range.minimum, range.maximum, histogramParts));
    return {};
}

/// The mesh in the focus, if there is one to blend.
Status SceneBuilder::Workshop::extractFine(const SceneRequest& request, const NeededMeshes& needed,
                                           const Progress& progress)
{
    session.reset();
    fineMesh.reset();
    focus.reset();
    if (!needed.focus)
        return {};
    auto extracted = extractor->extract(needed.focus->inside, progress);
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    fineMesh = *std::move(extracted);
    focus = needed.focus;
    return {};
}

void SceneBuilder::Workshop::open(const SceneRequest& request, const NeededMeshes& needed)
{
    const Eigen::AlignedBox3d bounds = request.model->description().bounds;
    const std::shared_ptr<const TetrahedralMesh> whole(mesh, &mesh->mesh);
    session = needed.focus
                  ? request.renderer->openWithFocus(
                        whole, {{fineMesh, &fineMesh->mesh}, needed.focus->region, needed.focus->border}, bounds)
                  : request.renderer->open(whole, bounds);
    renderer = request.renderer;
}

Result<BuiltScene> SceneBuilder::Workshop::make(const SceneRequest& request, const Progress& progress)
try {
    BuiltScene built;
    built.model = request.model;
    const auto start = std::chrono::steady_clock::now();
    const NeededMeshes needed(request);
    if (!has(request, needed)) {
        if (const Status extracted = extract(request, needed, progress.part(0, 0.3)); !extracted)
            return extracted.error();
        built.extractionSeconds = secondsSince(start);
    }
    if (focus != needed.focus) {
        if (const Status extracted = extractFine(request, needed, progress.part(0.3, 0.5)); !extracted)
            return extracted.error();
        built.extractionSeconds = secondsSince(start);
    }
    if (!session || renderer != request.renderer)
        open(request, needed);
    auto scene = session->prepare(request.values, request.camera, progress.part(0.5, 1));
    if (!scene)
        return scene.error();
    built.scene = *std::move(scene);
    const ExtractedMesh none;
    const ExtractedMesh& fine = fineMesh ? *fineMesh : none;
    built.mesh = {request.query,
                  mesh->mesh.positions.size() + fine.mesh.positions.size(),
                  mesh->mesh.tetrahedra.size() + fine.mesh.tetrahedra.size(),
                  mesh->wholeSites,
                  mesh->wholeTetrahedra,
                  mesh->scale,
                  histogram,
                  logarithmic};
    for (const Surface& surface : built.scene->surfaces)
        built.triangles += surface.mesh->triangles.size();
    built.sceneSeconds = secondsSince(start) - built.extractionSeconds;
    return built;
} catch (const std::bad_alloc&) {
    clear();
    return outOfMemory();
}

void SceneBuilder::Workshop::clear()
{
    session.reset();
    setMesh(nullptr);
    fineMesh.reset();
    focus.reset();
    extractor.reset();
}

SceneBuilder::SceneBuilder(QObject* parent)
    : QObject(parent), patience_(leastPatience), workshop_(std::make_shared<Workshop>())
{
}

SceneBuilder::~SceneBuilder() = default;

void SceneBuilder::request(SceneRequest request)
{
    setBusy(true);
    job_.submit(
        [this, number = ++newest_, workshop = workshop_, request = std::move(request)](const std::stop_token& stop) {
            Result<BuiltScene> result = workshop->make(request, Progress(stop, {}));
            QMetaObject::invokeMethod(
                this, [this, number, result = std::move(result)] { arrived(number, result); }, Qt::QueuedConnection);
        },
        patience_);
}

std::shared_ptr<const ExtractedMesh> SceneBuilder::mesh() const
{
    const std::lock_guard lock(workshop_->mutex);
    return workshop_->mesh;
}

void SceneBuilder::clear()
{
    cleared_ = newest_;
    // The worker gives back the mesh, in its own time.
    job_.submit([workshop = workshop_](const std::stop_token&) { workshop->clear(); });
    setBusy(false);
}

void SceneBuilder::arrived(quint64 number, const Result<BuiltScene>& result)
{
    if (number <= cleared_)
        return;
    if (number == newest_)
        setBusy(false);
    if (result)
        patience_ = patienceFor(result->extractionSeconds + result->sceneSeconds);
    if (result)
        emit sceneReady(*result);
    else if (result.error().kind != ErrorKind::Cancelled)
        emit failed(result.error());
}

void SceneBuilder::setBusy(bool busy)
{
    if (busy_ == busy)
        return;
    busy_ = busy;
    emit busyChanged(busy);
}

} // namespace tetra
