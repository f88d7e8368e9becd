// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/frame_pacer.h"

#include <tan/render.h>

#include <QImage>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QWidget;

namespace tetra {

/// A scene, and of how many tetrahedra it was made.
struct SceneLevel {
    std::shared_ptr<const Scene> scene;
    std::uint64_t tetrahedra = 0;
};

/// What a canvas shows.
struct View {
    std::vector<SceneLevel> levels; ///< what is to be seen, then coarser ones for moving pictures; none: the background
    Camera camera;
    Colour background;
    bool moving = false; ///< camera or scene are on their way: quick pictures count more than fine ones
};

/// How the picture on the screen was drawn.
struct FrameReport {
    double seconds = 0; ///< that drawing took
    bool moving = false;
    double framesPerSecond = 0; ///< while moving; 0 if there were too few to tell
    double reduction = 1;       ///< of width and height
    std::uint64_t tetrahedra = 0;
    std::size_t cells = 0;        ///< of volumes that were drawn
    std::size_t brokenCycles = 0; ///< of their visibility order (S14)
};

/// The part of the viewport that draws with one back end. It takes no input: that goes on to the viewport around it.
/// Used from the GUI thread.
class Canvas {
public:
    virtual ~Canvas() = default;
    virtual QWidget* widget() = 0;
    virtual QString backendName() const = 0;
    virtual void show(const View& view) = 0;
    /// Pictures a second to hold while something moves.
    virtual void setFrameRate(double perSecond) = 0;
    /// The rate to hold unless the user says otherwise.
    virtual double usualFrameRate() const = 0;
    /// True once the fine picture of the last view is on the screen.
    virtual bool settled() const = 0;
    /// The picture that is on the screen, in its own pixels.
    virtual QImage picture() = 0;

    std::function<void(const FrameReport& report)> framePainted; ///< called after each picture
    std::function<void(const QString& text)> failed;             ///< called when a picture could not be drawn
    std::function<void(const QString& text)> unusable; ///< called when this back end does not work here after all
};

/// Whether the fine pictures of both are the same: coarser levels do not matter to them.
bool haveSameStill(const View& first, const View& second);

/// Whether a moving picture of this level of `second` would show what was seen of `first` already: its scene is not
/// there yet.
bool wouldShowNothingNew(const View& first, const View& second, std::size_t level);

/// The levels of a view for the choice between them; one without anything if there are none.
std::vector<FrameLevel> frameLevels(const View& view);

} // namespace tetra
