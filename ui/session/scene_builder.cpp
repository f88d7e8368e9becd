// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/scene_builder.h"

#include "core/model/extraction.h"

#include <chrono>
#include <new>

namespace tetra {
namespace {

/// A scene that takes longer than this is given up for a newer one; a quicker one is finished and shown, so that the
/// picture follows a slider that is being dragged.
constexpr auto patience = std::chrono::milliseconds(300);

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Error outOfMemory()
{
    return {ErrorKind::OutOfResource,
            "There is not enough memory for the mesh at this accuracy. Choose a coarser one, or "
            "close other programs."};
}

} // namespace

/// What the worker keeps between two requests. Touched by the worker only.
struct SceneBuilder::Workshop {
    std::shared_ptr<const Model> model;
    const Renderer* renderer = nullptr;
    std::uint32_t sites = 0;
    std::shared_ptr<TetrahedralMesh> mesh;
    std::unique_ptr<RendererSession> session;

    Status extract(const SceneRequest& request, const Progress& progress);
    Result<BuiltScene> make(const SceneRequest& request, const Progress& progress);
};

Status SceneBuilder::Workshop::extract(const SceneRequest& request, const Progress& progress)
{
    session.reset();
    TetrahedralMesh reuse;
    if (mesh && mesh.use_count() == 1)
        reuse = std::move(*mesh);
    mesh.reset();
    auto extracted = extractPrefix(*request.model, request.sites, progress, std::move(reuse));
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    mesh = std::make_shared<TetrahedralMesh>(std::move(*extracted));
    model = request.model;
    sites = request.sites;
    return {};
}

Result<BuiltScene> SceneBuilder::Workshop::make(const SceneRequest& request, const Progress& progress)
try {
    BuiltScene built{request.model, nullptr, request.sites, 0, 0, 0, 0};
    const auto start = std::chrono::steady_clock::now();
    if (!mesh || model != request.model || sites != request.sites) {
        if (const Status extracted = extract(request, progress.part(0, 0.5)); !extracted)
            return extracted.error();
        built.extractionSeconds = secondsSince(start);
    }
    if (!session || renderer != request.renderer) {
        session = request.renderer->open(mesh, request.model->description().bounds);
        renderer = request.renderer;
    }
    auto scene = session->prepare(request.values, request.camera, progress.part(0.5, 1));
    if (!scene)
        return scene.error();
    built.scene = *std::move(scene);
    built.tetrahedra = mesh->tetrahedra.size();
    for (const Surface& surface : built.scene->surfaces)
        built.triangles += surface.mesh->triangles.size();
    built.sceneSeconds = secondsSince(start) - built.extractionSeconds;
    return built;
} catch (const std::bad_alloc&) {
    session.reset();
    mesh.reset();
    return outOfMemory();
}

SceneBuilder::SceneBuilder(QObject* parent) : QObject(parent), workshop_(std::make_shared<Workshop>()) {}

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
        patience);
}

void SceneBuilder::clear()
{
    cleared_ = newest_;
    // The worker gives back the mesh, in its own time.
    job_.submit([workshop = workshop_](const std::stop_token&) { *workshop = {}; });
    setBusy(false);
}

void SceneBuilder::arrived(quint64 number, const Result<BuiltScene>& result)
{
    if (number <= cleared_)
        return;
    if (number == newest_)
        setBusy(false);
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
