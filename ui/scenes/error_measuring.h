// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scenes/scene_builder.h"
#include "ui/session/session.h"
#include "ui/work/latest_job.h"

#include <QObject>

#include <memory>
#include <optional>

namespace tetra {

/// Measures in a worker, once a mesh is seen, the error in space beside that in the grid (measureInSpace()), and tells
/// the session, in whose ShownMesh it stands from then on. Meshes that are replaced meanwhile are left alone.
class ErrorMeasuring : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    ErrorMeasuring(SceneBuilder& scenes, Session& session) : scenes_(scenes), session_(session) {}

    /// A scene has come, and the session was told of it.
    void look(const BuiltScene& scene);

private:
    void tell(const std::optional<double>& largest);

    SceneBuilder& scenes_;
    Session& session_;
    quint64 newest_ = 0;
    std::weak_ptr<const ExtractedMesh> measured_; ///< the mesh ...
    std::optional<double> known_;                 ///< ... and what was found of it
    LatestJob job_;
};

} // namespace tetra
