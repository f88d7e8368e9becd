// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/work/latest_job.h"
#include "ui/workbench/scene_pipeline.h"

#include <QObject>

#include <chrono>
#include <memory>

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
    void busyChanged(bool busy);

private:
    void arrived(quint64 number, const Result<BuiltScene>& result);
    void setBusy(bool busy);

    quint64 newest_ = 0;
    quint64 cleared_ = 0; ///< requests up to this number are dropped
    bool busy_ = false;
    std::optional<BuiltScene> last_;
    std::chrono::milliseconds patience_;
    std::shared_ptr<ScenePipeline> pipeline_;
    LatestJob job_;
};

} // namespace tetra
