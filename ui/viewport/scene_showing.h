// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

namespace tetra {

class SceneService;
class Session;
class Viewport;

/// The pixels of the view on the screen.
QSize pixelsOf(const Viewport& viewport);

/// The viewport shows the scenes and the drafts that the service makes, and nothing when another model is opened; the
/// service hears from where they are seen. For as long as both are there, from then on: whoever is to hear of a scene
/// after it is shown, or of a model after the picture is emptied, connects later.
void showScenes(Session& session, SceneService& scenes, Viewport& viewport);

} // namespace tetra
