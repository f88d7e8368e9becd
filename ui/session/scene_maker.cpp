// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/scene_maker.h"

#include <chrono>
#include <new>

namespace tetra {
namespace {

constexpr int histogramParts = 256;

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Error outOfMemory()
{
    return {ErrorKind::OutOfResource,
            Message::say("There is not enough memory for the mesh at this accuracy. Choose a coarser one, or close "
                         "other programs.")};
}

} // namespace

/// The meshes that a request needs: one, or with a renderer that blends a focus two.
struct SceneMaker::NeededMeshes {
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

void SceneMaker::setMesh(std::shared_ptr<const ExtractedMesh> next)
{
    const std::lock_guard lock(mutex_);
    mesh_ = std::move(next);
}

bool SceneMaker::has(const SceneRequest& request, const NeededMeshes& needed) const
{
    return mesh_ && extractor_ && extractor_->model() == request.model && query_ == needed.query;
}

/// Lets go of the last mesh first, so that the extractor can use its memory again.
Status SceneMaker::extract(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress)
{
    session_.reset();
    setMesh(nullptr);
    fineMesh_.reset();
    focus_.reset();
    if (!extractor_ || extractor_->model() != request.model)
        extractor_.emplace(request.model);
    auto extracted = extractor_->extract(needed.query, progress);
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    setMesh(*std::move(extracted));
    query_ = needed.query;
    const ValueRange range = request.model->description().range;
    histogram_ = std::make_shared<const ValueHistogram>(
        valueHistogram(mesh_->mesh.values, range.minimum, range.maximum, histogramParts));
    logarithmic_.reset();
    if (range.minimum > 0)
        logarithmic_ = std::make_shared<const ValueHistogram>(
            logarithmicHistogram(mesh_->mesh.values, range.minimum, range.maximum, histogramParts));
    return {};
}

/// The mesh in the focus, if there is one to blend.
Status SceneMaker::extractFine(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress)
{
    session_.reset();
    fineMesh_.reset();
    focus_.reset();
    if (!needed.focus)
        return {};
    auto extracted = extractor_->extract(needed.focus->inside, progress);
    if (!extracted)
        return extracted.error();
    if (Status intact = request.model->checkIntact(); !intact)
        return intact;
    fineMesh_ = *std::move(extracted);
    focus_ = needed.focus;
    return {};
}

void SceneMaker::open(const SceneRequest& request, const NeededMeshes& needed)
{
    const Eigen::AlignedBox3d bounds = request.model->description().bounds;
    const std::shared_ptr<const TetrahedralMesh> whole(mesh_, &mesh_->mesh);
    session_ = needed.focus
                   ? request.renderer->openWithFocus(
                         whole, {{fineMesh_, &fineMesh_->mesh}, needed.focus->region, needed.focus->border}, bounds)
                   : request.renderer->open(whole, bounds);
    renderer_ = request.renderer;
}

ShownMesh SceneMaker::shownMesh(const MeshQuery& asked) const
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

Result<BuiltScene> SceneMaker::make(const SceneRequest& request, const Progress& progress)
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
    if (focus_ != needed.focus) {
        if (const Status extracted = extractFine(request, needed, progress.part(0.3, 0.5)); !extracted)
            return extracted.error();
        built.extractionSeconds = secondsSince(start);
    }
    if (!session_ || renderer_ != request.renderer)
        open(request, needed);
    auto scene = session_->prepare(request.values, request.camera, progress.part(0.5, 1));
    if (!scene)
        return scene.error();
    built.scene = *std::move(scene);
    built.mesh = shownMesh(request.query);
    for (const Surface& surface : built.scene->surfaces)
        built.triangles += surface.mesh->triangles.size();
    built.sceneSeconds = secondsSince(start) - built.extractionSeconds;
    return built;
} catch (const std::bad_alloc&) {
    clear();
    return outOfMemory();
}

std::shared_ptr<const ExtractedMesh> SceneMaker::mesh() const
{
    const std::lock_guard lock(mutex_);
    return mesh_;
}

void SceneMaker::clear()
{
    session_.reset();
    setMesh(nullptr);
    fineMesh_.reset();
    focus_.reset();
    extractor_.reset();
}

} // namespace tetra
