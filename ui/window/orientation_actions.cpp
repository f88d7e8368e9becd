// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/orientation_actions.h"

#include "ui/session/session.h"
#include "ui/viewport/camera_controls.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/actions.h"
#include "ui/window/palette_commands.h"

#include <QActionGroup>
#include <QMenu>

#include <array>

namespace tetra {
namespace {

/// In the order of UpAxis.
constexpr std::array upActionNames{"x", "minusX", "y", "minusY", "z", "minusZ"};
constexpr double quarterTurn = 90;

} // namespace

OrientationActions::OrientationActions(Session& session, QMenu& menu)
    : QObject(&menu), session_(session), upAxes_(new QActionGroup(this))
{
    addUpAxes(menu);
    menu.addSeparator();
    flip_ = addAction(menu, "flip", tr("Turn Upside Down"), QKeySequence("Ctrl+U"), tr("Flip the up axis"));
    rollRight_ = addAction(menu, "rollRight", tr("Roll Clockwise"), QKeySequence("Ctrl+R"),
                           tr("Turn the picture by 90° clockwise"));
    rollLeft_ = addAction(menu, "rollLeft", tr("Roll Anticlockwise"), QKeySequence("Ctrl+Shift+R"),
                          tr("Turn the picture by 90° anticlockwise"));
    level_ =
        addAction(menu, "level", tr("Level"), QKeySequence("Ctrl+L"), tr("Remove the roll: make the up axis vertical"));
    menu.addSeparator();
    trackball_ = addAction(menu, "trackball", tr("Trackball"), QKeySequence("Ctrl+T"),
                           tr("Dragging turns the model freely in any direction, instead of around the up axis"));
    trackball_->setCheckable(true);
    giveMnemonics(menu);

    const auto edits = [this](QAction* action, auto change) {
        connect(action, &QAction::triggered, this,
                [this, change] { session_.setCamera(change(session_.view().camera)); });
    };
    edits(flip_, [](const Camera& camera) { return upright(camera, opposite(camera.up)); });
    edits(rollRight_, [](const Camera& camera) { return rolled(camera, quarterTurn); });
    edits(rollLeft_, [](const Camera& camera) { return rolled(camera, -quarterTurn); });
    edits(level_, [](const Camera& camera) { return upright(camera, camera.up); });
    edits(trackball_, [](Camera camera) {
        camera.trackball = !camera.trackball;
        return camera;
    });
    for (QAction* action : upAxes_->actions())
        edits(action,
              [up = static_cast<UpAxis>(action->data().toInt())](const Camera& camera) { return upright(camera, up); });
    connect(&session_, &Session::modelChanged, this, &OrientationActions::follow);
    session_.whenChanged(ViewPart::Camera, this, &OrientationActions::follow);
    follow();
}

void OrientationActions::addUpAxes(QMenu& menu)
{
    for (std::size_t i = 0; i < upActionNames.size(); ++i) {
        const auto up = static_cast<UpAxis>(i);
        const QByteArray name = QByteArray("up.") + upActionNames[i];
        QAction* action =
            addAction(menu, name.constData(), upAxisText(up), {}, tr("Show the model with this axis upright"));
        action->setCheckable(true);
        action->setData(static_cast<int>(up));
        upAxes_->addAction(action);
    }
}

void OrientationActions::follow()
{
    const bool isOpen = session_.model() != nullptr;
    const Camera& camera = session_.view().camera;
    for (QAction* action : QList<QAction*>{flip_, rollRight_, rollLeft_, level_, trackball_} + upAxes_->actions()) {
        action->setEnabled(isOpen);
        setNeed(*action, tr("Open a model first"));
    }
    for (QAction* action : upAxes_->actions())
        action->setChecked(action->data().toInt() == static_cast<int>(camera.up));
    if (isOpen && camera.roll == 0) {
        level_->setEnabled(false);
        setNeed(*level_, tr("The picture is not rolled"));
    }
    trackball_->setChecked(camera.trackball);
}

} // namespace tetra
