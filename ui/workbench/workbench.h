// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/opening/opening.h"
#include "ui/scenes/scene_service.h"
#include "ui/session/session.h"
#include "ui/workbench/building.h"
#include "ui/workbench/exporting.h"

namespace tetra {

/// Everything that the window can do, without the window: what is open, and the four that work with it. All work is
/// done in workers; signals come in the thread that it lives in.
class Workbench : public QObject {
    Q_OBJECT
public:
    /// `host` outlives it. How models are seen is kept in the folder `views`.
    explicit Workbench(PluginHost& host, std::filesystem::path views = viewFolder());
    ~Workbench() override;

    PluginHost& host() noexcept { return host_; }
    Session& session() noexcept { return session_; }
    const Session& session() const noexcept { return session_; }
    SceneService& scenes() noexcept { return scenes_; }
    const SceneService& scenes() const noexcept { return scenes_; }
    Opening& opening() noexcept { return opening_; }
    Building& building() noexcept { return building_; }
    Exporting& exporting() noexcept { return exporting_; }
    const Exporting& exporting() const noexcept { return exporting_; }
    /// Whether a file is being written that is neither a model nor a film.
    bool saving() noexcept { return exporting_.saving() || opening_.sessionFile().saving().running(); }

signals:
    /// Something could not be opened or shown, by whichever of them.
    void failed(const QString& text);
    /// A file was not written, likewise.
    void saveFailed(const QString& text);

private:
    PluginHost& host_;
    Session session_;
    SceneService scenes_;
    Opening opening_;
    Building building_;
    Exporting exporting_;
};

} // namespace tetra
