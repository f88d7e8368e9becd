// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/scene.h"
#include "core/model/model.h"
#include "plugins/api/renderer.h"
#include "ui/session/shown_mesh.h"
#include "ui/work/latest_job.h"

#include <QObject>

#include <chrono>
#include <memory>

namespace tetra {

/// What is to be seen: what a model answers to a query, looked at in a renderer's way. The renderer outlives the
/// builder.
struct SceneRequest {
    std::shared_ptr<const Model> model;
    const Renderer* renderer = nullptr;
    MeshQuery query;
    ParameterValues values;
    Camera camera;
};

/// What was made of a request.
struct BuiltScene {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const Scene> scene;
    ShownMesh mesh;
    std::uint64_t triangles = 0;
    double extractionSeconds = 0; ///< of the mesh; zero if the last one was used again
    double sceneSeconds = 0;      ///< of the renderer
};

/// Makes scenes in a worker: extracts the mesh from what the last extraction left, or uses the last one again, and lets
/// the renderer prepare it. The newest request wins. Used from the thread that it lives in, where it emits its signals.
class SceneBuilder : public QObject {
    Q_OBJECT
public:
    explicit SceneBuilder(QObject* parent = nullptr);
    ~SceneBuilder() override;

    void request(SceneRequest request);
    /// Drops what was asked for; nothing that was asked for before arrives any more.
    void clear();
    /// Whether a scene that was asked for is still to come.
    bool busy() const noexcept { return busy_; }
    /// The mesh of the last scene; none while the worker makes the next one.
    std::shared_ptr<const ExtractedMesh> mesh() const;

signals:
    void sceneReady(const tetra::BuiltScene& scene);
    void failed(const tetra::Error& error);
    void busyChanged(bool busy);

private:
    struct Workshop;
    void arrived(quint64 number, const Result<BuiltScene>& result);
    void setBusy(bool busy);

    quint64 newest_ = 0;
    quint64 cleared_ = 0; ///< requests up to this number are dropped
    bool busy_ = false;
    std::chrono::milliseconds patience_;
    std::shared_ptr<Workshop> workshop_;
    LatestJob job_;
};

} // namespace tetra
