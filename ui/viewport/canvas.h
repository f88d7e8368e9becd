// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"
#include "core/graphics/scene.h"

#include <QImage>
#include <QString>

#include <functional>
#include <memory>

class QWidget;

namespace tetra {

/// What a canvas shows.
struct View {
    std::shared_ptr<const Scene> scene; ///< may be missing: only the background
    Camera camera;
    Colour background;
    bool moving = false; ///< the camera is on its way: quick pictures count more than fine ones
};

/// The part of the viewport that draws with one back end. It takes no input: that goes on to the viewport around it.
/// Used from the GUI thread.
class Canvas {
public:
    virtual ~Canvas() = default;
    virtual QWidget* widget() = 0;
    virtual QString backendName() const = 0;
    virtual void show(const View& view) = 0;
    /// True once the fine picture of the last view is on the screen.
    virtual bool settled() const = 0;
    /// The picture that is on the screen, in its own pixels.
    virtual QImage picture() = 0;

    std::function<void(double seconds)> framePainted; ///< called after each picture, with the time that drawing it took
    std::function<void(const QString& text)> failed;  ///< called when a picture could not be drawn
    std::function<void(const QString& text)> unusable; ///< called when this back end does not work here after all
};

} // namespace tetra
