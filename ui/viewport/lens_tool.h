// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/lens_painter.h"
#include "core/view/lens.h"
#include "ui/scenes/scene_builder.h"
#include "ui/session/session.h"
#include "ui/work/latest_job.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace tetra {

class Viewport;
class Workbench;

/// The lens over the picture (C5): a drag moves it, the wheel over it changes its magnification; Alt and the arrow keys
/// or plus and minus do the same, and Escape ends it. Each drag, and each series of turns or keys, is one step to undo.
///
/// What is seen in it is at first the picture enlarged, then the scene of the picture drawn for it, and when all is at
/// rest that of its own finer mesh. Meshes and pictures are made in workers.
class LensTool : public QWidget {
    Q_OBJECT
public:
    /// A child of the viewport, below what is made after it, which gets the events first.
    LensTool(Workbench& workbench, Viewport& viewport);
    ~LensTool() override;

    /// Whether the fine picture of the present lens is on the screen.
    bool settled() const noexcept { return settled_; }
    /// What was drawn for it last.
    const std::optional<DrawnLens>& drawn() const noexcept { return drawn_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void failed(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Backend;
    struct Order;

    const LensState& lens() const;
    bool isOn() const;
    bool holds(QPointF pixel) const;
    QSize pixels() const;
    LensPicture place() const;
    SceneRequest request() const;
    void follow();
    void rest();
    void draw(std::shared_ptr<const Scene> scene, std::size_t tetrahedra, bool fine);
    void arrived(const Order& order, const Picture& picture, const QString& error);
    void change(LensState lens);
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release();
    bool wheel(const QWheelEvent& event);
    bool keyPress(const QKeyEvent& event);
    void endDrag();
    Picture enlargedPicture() const;

    Workbench& workbench_;
    Viewport& viewport_;
    SceneBuilder builder_; ///< of its own mesh
    QTimer resting_;
    QTimer pausing_; ///< from the last turn or key until a series has ended
    Gesture series_ = 0;
    std::optional<QPointF> grabbed_; ///< while it is dragged: from its middle to the pointer
    LensState atPress_;
    std::optional<DrawnLens> drawn_;
    Camera drawnCamera_;
    quint64 newest_ = 0; ///< the number of the last change
    bool settled_ = false;
    bool wasOn_ = false;
    std::shared_ptr<Backend> backend_; ///< the worker's
    LatestJob job_;
};

} // namespace tetra
