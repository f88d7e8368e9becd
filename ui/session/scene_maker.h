// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"
#include "ui/session/shown_mesh.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>

#include <memory>
#include <mutex>
#include <optional>

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
};

/// Whether the scene of `first` is also that of `second`.
bool haveSameScene(const SceneRequest& first, const SceneRequest& second);

/// What was made of a request.
struct BuiltScene {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const Scene> scene;
    ShownMesh mesh;
    std::uint64_t triangles = 0;
    double extractionSeconds = 0; ///< of the mesh; zero if the last one was used again
    double sceneSeconds = 0;      ///< of the renderer
};

/// Makes scenes, for the window as for the command line: extracts the mesh from what the last extraction left, or uses
/// the last one again, and lets the renderer prepare it; the last scene comes again if nothing that it depends on has
/// changed. Used from one thread at a time, but for mesh().
class SceneMaker {
public:
    Result<BuiltScene> make(const SceneRequest& request, const Progress& progress);
    /// The mesh of the last scene, that outside of a focus if two are blended; none while the next one is made.
    std::shared_ptr<const ExtractedMesh> mesh() const;
    /// Gives back what it keeps.
    void clear();

private:
    struct NeededMeshes;
    void setMesh(std::shared_ptr<const ExtractedMesh> next);
    void forgetScene();
    bool has(const SceneRequest& request, const NeededMeshes& needed) const;
    Status extract(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress);
    Status extractFine(const SceneRequest& request, const NeededMeshes& needed, const Progress& progress);
    void open(const SceneRequest& request, const NeededMeshes& needed);
    ShownMesh shownMesh(const MeshQuery& asked) const;

    std::optional<MeshExtractor> extractor_;
    std::optional<SceneRequest> made_; ///< of the last scene, if that can come again
    BuiltScene scene_;                 ///< of it
    const Renderer* renderer_ = nullptr;
    std::optional<MeshQuery> query_;                ///< that the mesh answers
    std::optional<TwoResolutions> focus_;           ///< that the session blends; none if it does not
    std::shared_ptr<const ExtractedMesh> fineMesh_; ///< in the focus
    std::unique_ptr<RendererSession> session_;
    std::shared_ptr<const ValueHistogram> histogram_; ///< of the mesh
    std::shared_ptr<const ValueHistogram> logarithmic_;
    mutable std::mutex mutex_; ///< guards the next one
    std::shared_ptr<const ExtractedMesh> mesh_;
};

} // namespace tetra
