// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/scene_pipeline.h"
#include "ui/animation/frame_pacer.h"
#include "ui/work/latest_job.h"

#include <QObject>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// Makes scenes in a worker. The newest request wins. Used from the thread that it lives in, where it emits its
/// signals.
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
    /// The last scene that arrived; none after clear().
    const std::optional<BuiltScene>& last() const noexcept { return last_; }
    /// The mesh of the last scene; none while the worker makes the next one.
    std::shared_ptr<const ExtractedMesh> mesh() const;

signals:
    void sceneReady(const tetra::BuiltScene& scene);
    void failed(const tetra::Error& error);
    /// The samples that were asked for are not there, so that the last scene shows the mesh; told once.
    void samplesMissed(const tetra::Error& error);
    void busyChanged(bool busy);

private:
    /// What a worker made of a request.
    struct Made {
        Result<BuiltScene> scene;
        std::optional<Error> missed{}; ///< why it is of the mesh
    };

    static Made make(ScenePipeline& pipeline, const SceneRequest& request, const Progress& progress);
    void arrived(quint64 number, const Made& made);
    void tellMissed(const std::optional<Error>& missed);
    void setBusy(bool busy);

    quint64 newest_ = 0;
    quint64 cleared_ = 0; ///< requests up to this number are dropped
    bool busy_ = false;
    std::optional<BuiltScene> last_;
    std::string lastMissed_; ///< what was told last of samples that are not there; empty if they are
    std::chrono::milliseconds patience_;
    std::shared_ptr<ScenePipeline> pipeline_;
    LatestJob job_;
};

/// A scene of a coarser mesh than that which is seen.
struct DraftScene {
    std::shared_ptr<const Scene> scene;
    std::uint64_t tetrahedra = 0;
};

/// Prepares in a worker what can be drawn quickly while the camera moves or a slider is dragged (R23): the same scene
/// of a few coarser meshes, or of the one that the user chose (C4). Meshes are extracted only when the query changes;
/// what the renderer keeps of them makes other changes quick. The newest request wins. Used from the thread that it
/// lives in, where it emits its signals.
class DraftBuilder : public QObject {
    Q_OBJECT
public:
    explicit DraftBuilder(QObject* parent = nullptr);
    ~DraftBuilder() override;

    /// Of which meshes, from now on.
    void setQuality(const MovingQuality& quality);
    /// The scene of `request`, whose mesh is `shown`.
    void request(const SceneRequest& request, const ShownMesh& shown);
    /// The same meshes as the last request, seen otherwise; nothing if that was about other meshes.
    void requestAppearance(const SceneRequest& request);
    /// Nothing that was asked for arrives any more, and meshes are given back.
    void clear();

signals:
    /// The finest first; coarse ones come before all are there, and none at once when the mesh is another one.
    void draftsReady(const std::vector<tetra::DraftScene>& drafts);

private:
    struct Pipelines;
    void submit(const SceneRequest& request);

    quint64 newest_ = 0;
    quint64 cleared_ = 0;              ///< requests up to this number are dropped
    std::optional<SceneRequest> last_; ///< that was asked for
    ShownMesh shown_;                  ///< of it
    MovingQuality quality_;
    std::shared_ptr<Pipelines> pipelines_;
    LatestJob job_;
};

} // namespace tetra
