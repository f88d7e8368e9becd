// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/editor.h"
#include "ui/viewport/scene_pick.h"
#include "ui/workbench/workbench.h"

#include <QWidget>

class QMouseEvent;

namespace tetra {

class Viewport;

/// Finds the value of the data that is seen where the user clicks in the picture, and marks its place there: on an
/// isosurface its isovalue, on the boundary the value there, in a volume the value that most is seen of (seenPlace()).
/// A click is a press of the left button without a drag and without keys. Looks for it in a worker; the same with
/// either back end, as nothing is read from the picture. The mark goes with Escape, with a click beside everything, and
/// with another model.
class ValuePick : public QWidget {
    Q_OBJECT
public:
    /// A child of the viewport, below the tools that are made after it, which get the events first.
    ValuePick(Workbench& workbench, Viewport& viewport);

    const std::optional<PickedValue>& picked() const noexcept { return picked_; }
    /// "1.244 at (3.2, 0.5, 0)", the value as the data have it; empty if nothing is picked.
    QString text() const;
    /// Picks what is seen at a pixel of the viewport, once the picture is up to date.
    void pickAt(QPointF pixel);
    /// At the pointer, or in the middle of the picture if the pointer is elsewhere.
    void pickAtPointer();
    void forget();
    /// Whether clicks pick: not while they mean something else.
    void setClickable(bool clickable) { clickable_ = clickable; }
    /// Whether a value that was asked for is still being looked for.
    bool busy() const noexcept { return wanted_ || seen_.busy(); }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pickedChanged();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void followMouse(const QMouseEvent& event);
    void look();
    void setPicked(const std::optional<PickedValue>& picked);

    Workbench& workbench_;
    Viewport& viewport_;
    std::optional<PickedValue> picked_;
    std::optional<QPointF> pressed_; ///< the button, there, and not moved since
    std::optional<QPointF> wanted_;  ///< to be picked when the picture is up to date
    ScenePick seen_;
    bool clickable_ = true;
};

} // namespace tetra
