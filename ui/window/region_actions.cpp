// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/region_actions.h"

#include "plugins/widgets/icons.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/palette_commands.h"

#include <QCursor>
#include <QMenu>
#include <QToolBar>

#include <algorithm>

namespace tetra {

RegionActions::RegionActions(Session& session, Viewport& viewport, QMenu& menu, QToolBar& toolBar)
    : QObject(&menu), session_(session), viewport_(viewport),
      sphere_(addAction(menu, "focusSphere", tr("Focus: &Sphere"), QKeySequence("F"), tr("More accurate in a sphere"))),
      box_(addAction(menu, "focusBox", tr("Focus: &Box"), QKeySequence("B"), tr("More accurate in a box"))),
      toView_(addAction(menu, "focusToView", tr("Focus to &Centre of View"), QKeySequence("C"),
                        tr("Move the focus to the camera's target")))
{
    menu.addSeparator();
    window_ =
        addAction(menu, "window", tr("Crop Bo&x"), QKeySequence("W"), tr("Show only the part of the domain in a box"));
    lens_ = addAction(menu, "lens", tr("&Lens"), QKeySequence("L"),
                      tr("Enlarge a part of the picture, at its own accuracy"));
    lens_->setIcon(glyphIcon(Glyph::Lens));
    sphere_->setIcon(glyphIcon(Glyph::Sphere));
    box_->setIcon(glyphIcon(Glyph::Box));
    window_->setIcon(glyphIcon(Glyph::Window));
    setNeed(*toView_, tr("Turn on a focus first"));
    for (QAction* action : {sphere_, box_, window_, lens_}) {
        setNeed(*action, tr("Open a model first"));
        action->setCheckable(true);
        toolBar.addAction(action);
    }
    connect(sphere_, &QAction::triggered, this, [this](bool on) { chooseShape(FocusState::Shape::Sphere, on); });
    connect(box_, &QAction::triggered, this, [this](bool on) { chooseShape(FocusState::Shape::Box, on); });
    connect(window_, &QAction::triggered, this, &RegionActions::chooseWindow);
    connect(lens_, &QAction::triggered, this, &RegionActions::chooseLens);
    connect(toView_, &QAction::triggered, this, &RegionActions::focusToView);
    connect(&session_, &Session::modelChanged, this, &RegionActions::follow);
    session_.whenChanged(ViewPart::Query | ViewPart::Lens, this, &RegionActions::follow);
    follow();
}

void RegionActions::chooseShape(FocusState::Shape shape, bool on)
{
    FocusState focus = session_.view().query.focus;
    focus.shape = on ? shape : FocusState::Shape::None;
    session_.setFocus(focus);
    if (on)
        emit focusSwitchedOn();
}

void RegionActions::chooseWindow(bool on)
{
    WindowState window = session_.view().query.window;
    window.enabled = on;
    session_.setWindow(window);
    if (on)
        emit windowSwitchedOn();
}

/// Under the pointer, if that is over the picture.
void RegionActions::chooseLens(bool on)
{
    LensState lens = session_.view().lens;
    lens.shape = on ? LensState::Shape::Circle : LensState::Shape::None;
    const QPointF pointer = viewport_.mapFromGlobal(QCursor::pos());
    if (on && viewport_.underMouse()) {
        lens.x = pointer.x() / std::max(1, viewport_.width());
        lens.y = pointer.y() / std::max(1, viewport_.height());
    }
    session_.setLens(lens);
    if (on)
        emit lensSwitchedOn();
}

void RegionActions::focusToView()
{
    FocusState focus = session_.view().query.focus;
    focus.centre = session_.view().camera.target;
    session_.setFocus(focus);
}

void RegionActions::follow()
{
    const QueryState& query = session_.view().query;
    const bool isOpen = session_.model() != nullptr;
    for (QAction* action : {sphere_, box_, window_, lens_})
        action->setEnabled(isOpen);
    toView_->setEnabled(isOpen && query.focus.isRegion());
    sphere_->setChecked(query.focus.shape == FocusState::Shape::Sphere);
    box_->setChecked(query.focus.shape == FocusState::Shape::Box);
    window_->setChecked(query.window.enabled);
    lens_->setChecked(session_.view().lens.isOn());
}

} // namespace tetra
