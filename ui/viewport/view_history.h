// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <QObject>

#include <cstdint>
#include <optional>

class QUndoStack;

namespace tetra {

class Viewport;

/// From where it is looked, and before what.
struct ViewChoice {
    Camera camera;
    std::optional<Colour> background; ///< none: the one that fits the palette
    bool operator==(const ViewChoice&) const = default;
};

/// Makes undo steps of what the user does to camera and background, one for each gesture: a drag, a series of wheel
/// turns or keys, a named view. Steps are merged while a gesture lasts, so that the stack is always up to date.
class ViewHistory : public QObject {
    Q_OBJECT
public:
    /// Both outlive it, and every step on the stack.
    ViewHistory(Viewport& viewport, QUndoStack& stack, QObject* parent);

    /// Shows a view that is on the stack already.
    void show(const ViewChoice& view);

private:
    ViewChoice chosen() const;
    void follow();

    Viewport& viewport_;
    QUndoStack& stack_;
    ViewChoice last_; ///< that the stack knows
};

} // namespace tetra
