// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"
#include "ui/viewport/region_handles.h"
#include "ui/viewport/scene_pick.h"

#include <QColor>
#include <QWidget>

class QKeyEvent;
class QMouseEvent;

namespace tetra {

class Viewport;

/// The tools that move focus and window in the picture: outlines and handles, by mouse and by keys. The region that was
/// switched on or grabbed last is selected: it has all its handles and takes the arrow keys; of the other one there is
/// the centre. What a drag does is one step of the undo stack, or none if Escape ends it. Lies over the viewport and
/// takes its events before the camera gets them.
class RegionTools : public QWidget {
    Q_OBJECT
public:
    /// A child of the viewport.
    RegionTools(Session& session, Viewport& viewport);

    RegionKind selected() const noexcept { return selected_; }
    void select(RegionKind kind);
    /// Where the selected region's handles are seen, for those who want to grab one.
    std::vector<RegionHandle> handles() const;
    bool dragging() const noexcept { return drag_.has_value(); }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The focus was brought to a place on a surface.
    void focusPlaced();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Grip {
        RegionKind region = RegionKind::None;
        RegionHandle handle;
    };

    const QueryState& query() const { return session_.view().query; }
    QColor ground() const;
    void place(const MovableRegion& place);
    std::vector<RegionHandle> handlesOf(RegionKind kind) const;
    std::optional<Grip> gripAt(QPointF pixel) const;

    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool doubleClick(const QMouseEvent& event);
    void bringFocusTo(const Eigen::Vector3d& place);
    bool keyPress(const QKeyEvent& event);
    bool keyRelease(const QKeyEvent& event);
    bool keyWhileDragging(const QKeyEvent& event);
    bool selectNext();
    bool moveByKey(const QKeyEvent& event);
    void drag(Qt::KeyboardModifiers modifiers);
    void endDrag();
    void letGo();
    void cancelDrag();
    void hover(const std::optional<Grip>& grip);
    void followQuery();
    void showOutlines();

    /// What an outline was made of.
    struct Outlined {
        MovableRegion place;
        QColor colour;
        bool operator==(const Outlined&) const = default;
    };

    Session& session_;
    Viewport& viewport_;
    std::vector<Outlined> outlined_;
    RegionKind selected_ = RegionKind::None;
    bool focusWasOn_ = false;
    bool windowWasOn_ = false;
    std::optional<Grip> hovered_;
    std::optional<RegionDrag> drag_; ///< of the selected region
    bool cancelled_ = false;         ///< a drag was, and its button is still down
    DragRule rule_;
    QPointF pointer_; ///< of the drag, last
    ScenePick place_; ///< that was double-clicked
};

} // namespace tetra
