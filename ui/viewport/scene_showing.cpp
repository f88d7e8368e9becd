// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_showing.h"

#include "ui/scenes/scene_service.h"
#include "ui/session/session.h"
#include "ui/viewport/viewport.h"

#include <utility>

namespace tetra {

QSize pixelsOf(const Viewport& viewport)
{
    return viewport.size() * viewport.devicePixelRatioF();
}

void showScenes(Session& session, SceneService& scenes, Viewport& viewport)
{
    QObject::connect(&session, &Session::modelChanged, &viewport, [&viewport] { viewport.setScene(nullptr); });
    QObject::connect(&scenes.sceneBuilder(), &SceneBuilder::sceneReady, &viewport,
                     [&viewport](const BuiltScene& scene) { viewport.setScene(scene.scene, scene.mesh.tetrahedra); });
    QObject::connect(&scenes.draftBuilder(), &DraftBuilder::draftsReady, &viewport,
                     [&viewport](const std::vector<DraftScene>& drafts) {
                         std::vector<SceneLevel> levels;
                         for (const DraftScene& draft : drafts)
                             levels.push_back({draft.scene, draft.tetrahedra});
                         viewport.setDrafts(std::move(levels));
                     });
    const auto tellCamera = [&scenes, &viewport] { scenes.setSeenFrom(viewport.shownCamera(), pixelsOf(viewport)); };
    QObject::connect(&viewport, &Viewport::cameraChanged, &scenes, tellCamera);
    QObject::connect(&viewport, &Viewport::previewChanged, &scenes, tellCamera);
    QObject::connect(&viewport, &Viewport::resized, &scenes, tellCamera);
}

} // namespace tetra
