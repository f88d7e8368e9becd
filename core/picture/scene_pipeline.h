// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/picture_order.h"
#include "core/picture/shown_mesh.h"
#include "core/view/lens.h"
#include "plugins/api/renderer.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/view.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace tetra {

/// What is to be seen: what a model answers to a query, looked at in a renderer's way. The renderer outlives the
/// builder.
struct SceneRequest {
    std::shared_ptr<const Model> model;
    const Renderer* renderer = nullptr;
    MeshQuery query;
    ParameterValues values;
    Camera camera; ///< this and the size of the picture matter if the renderer needs them
    int width = 1024;
    int height = 768;
    bool faultyCells = false; ///< outlined over the rest, as far as the model knows where they lie (C10)
    /// Where the samples come from, if `values` ask for them (shownId); without it, the mesh is shown.
    std::function<Result<std::shared_ptr<const Dataset>>(const Model& model, const Progress& progress)> samples{};
    /// If nobody has chosen a transfer function: the one of another query's mesh. For who draws coarser meshes of the
    /// same scene (withQuery()). Any thread may call it.
    std::function<TransferFunction(const MeshQuery& query)> usualTransfer{};
};

/// The same of another mesh, with the transfer function of that one if nobody has chosen one: it paints nothing into
/// the background that the larger error of a coarser mesh has made.
SceneRequest withQuery(SceneRequest request, MeshQuery query);

/// Whether the samples are to be seen in the place of the mesh, or what both differ in.
bool asksForSamples(const SceneRequest& request);
/// The same that shows the mesh, whatever was asked for.
SceneRequest withMesh(SceneRequest request);

/// Of all its surfaces.
std::uint64_t triangleCount(const Scene& scene);
/// Whether it shows the inside of tetrahedra.
bool hasVolume(const Scene& scene);
/// Makes all its lines so many times as wide.
void scaleLines(Scene& scene, double factor);

/// Whether the scene of one is also that of the other.
bool haveSameScene(const SceneRequest& one, const SceneRequest& other);

/// A lens over a picture.
struct LensOrder {
    LensState lens;
    SceneRequest scene; ///< of the picture
};

/// The scene in a lens that lies there in a picture that this camera takes: of its own mesh.
SceneRequest lensScene(const LensOrder& order, const LensPicture& place, const Camera& camera);

/// What was made of a request.
struct BuiltScene {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const Scene> scene;
    ShownMesh mesh;
    std::uint64_t triangles = 0;
    std::optional<std::uint64_t> faultyCells{}; ///< that are outlined, if that was asked for
    double extractionSeconds = 0;               ///< of the mesh; zero if the last one was used again
    double sceneSeconds = 0;                    ///< of the renderer
};

/// The way from a model to a picture of it, for the window, its drafts, films and the command line: extracts the mesh,
/// or uses the last one again, and lets the renderer prepare it. A request like the last one returns at once. Used from
/// one thread at a time, but for mesh().
class ScenePipeline {
public:
    /// What one extraction leaves to the next: pipelines that work in turn can share it.
    using Extractor = std::shared_ptr<std::optional<MeshExtractor>>;

    /// Draws with the CPU unless it gets another back end.
    explicit ScenePipeline(std::unique_ptr<RenderBackend> backend = makeCpuBackend(),
                           Extractor extractor = std::make_shared<std::optional<MeshExtractor>>())
        : backend_(std::move(backend)), extractor_(std::move(extractor))
    {
    }

    Result<BuiltScene> make(const SceneRequest& request, const Progress& progress);
    /// The picture as the back end draws it, with its depths if they are wanted, but nothing painted over it. The order
    /// of cells of one picture helps with the next.
    Result<Picture> draw(const PictureOrder& order, bool withDepth, const Progress& progress);
    /// A picture that was drawn with all else that was ordered, the lens included.
    Result<Picture> finish(const PictureOrder& order, Picture picture, const Progress& progress);
    /// What is seen in the lens of an order.
    Result<DrawnLens> drawLens(const PictureOrder& order, const Progress& progress);
    /// Of the last picture.
    RenderStatistics statistics() const { return backend_->statistics(); }
    /// The mesh of the last scene, that outside of a focus if two are blended; none while the next one is made.
    std::shared_ptr<const ExtractedMesh> mesh() const;
    /// Gives back what it keeps.
    void clear();

private:
    struct NeededMeshes;
    void setMesh(std::shared_ptr<const ExtractedMesh> next);
    MeshExtractor& extractorOf(const std::shared_ptr<const Model>& model);
    bool has(const SceneRequest& request, const NeededMeshes& needed) const;
    Status extract(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress);
    Status extractFine(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress);
    void open(const SceneRequest& request, const NeededMeshes& needed);
    ShownMesh shownMesh(const Model& model, const MeshQuery& asked) const;
    Status outlineFaultyCells(BuiltScene& built);
    Status showSamples(const SceneRequest& request, BuiltScene& built, const Progress& progress);

    std::unique_ptr<RenderBackend> backend_;
    Extractor extractor_;
    std::shared_ptr<const Model> model_; ///< of the mesh
    SceneRequest last_;                  ///< that `built_` is of
    std::optional<BuiltScene> built_;
    const Renderer* renderer_ = nullptr;
    std::optional<MeshQuery> query_;                ///< that the mesh answers
    std::optional<TwoResolutions> focus_;           ///< that the session blends; none if it does not
    std::shared_ptr<const ExtractedMesh> fineMesh_; ///< in the focus
    std::unique_ptr<RendererSession> session_;
    Eigen::AlignedBox3d meshBounds_;                  ///< ShownMesh::bounds
    std::shared_ptr<const ValueHistogram> histogram_; ///< of the mesh
    std::shared_ptr<const ValueHistogram> logarithmic_;
    std::shared_ptr<const Model> outlinedModel_; ///< of which the next one is
    std::vector<FaultyCell> outlined_;           ///< faulty cells with known places
    std::shared_ptr<const Model> sampledModel_;  ///< of which the next one is
    std::optional<SampledVolumeCache> samples_;
    mutable std::mutex mutex_; ///< guards the next one
    std::shared_ptr<const ExtractedMesh> mesh_;
};

/// A picture with all that was ordered, drawn by the CPU.
Result<Picture> drawPicture(const PictureOrder& order, const Progress& progress);
/// The same of the scene of a request, in place of that of the order.
Result<Picture> drawPicture(PictureOrder order, const SceneRequest& scene, const Progress& progress);

} // namespace tetra
