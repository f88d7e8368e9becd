// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/pick_actions.h"

#include "plugins/api/scene_parameters.h"
#include "plugins/widgets/curves/joined_function.h"
#include "ui/viewport/value_pick.h"
#include "ui/window/actions.h"
#include "ui/window/palette_commands.h"
#include "ui/workbench/workbench.h"

#include <tan/transfer.h>

#include <QMenu>

namespace tetra {

PickActions::PickActions(Workbench& workbench, ValuePick& pick, QMenu& menu)
    : QObject(&menu), workbench_(workbench), pick_(pick),
      pickValue_(addAction(menu, "pickValue", tr("&Pick"), QKeySequence("P"),
                           tr("Pick the value at the pointer, or in the centre of the picture"))),
      isovalue_(addAction(menu, "isovalueHere", tr("&Isosurface at This Value"), QKeySequence("I"),
                          tr("Add an isosurface of the picked value"))),
      point_(addAction(menu, "pointHere", tr("Add &Transfer-Function Point"), QKeySequence("T"),
                       tr("Add a point to the transfer function at the picked value"))),
      forget_(addAction(menu, "forgetPicked", tr("&Clear Mark"), {}, tr("Clear the picked value")))
{
    setNeed(*pickValue_, tr("Open a model first"));
    for (QAction* action : {isovalue_, point_, forget_})
        setNeed(*action, tr("Click or pick a place in the picture first"));
    connect(pickValue_, &QAction::triggered, &pick, &ValuePick::pickAtPointer);
    connect(isovalue_, &QAction::triggered, this, [this] {
        if (pick_.picked())
            workbench_.session().addIsovalue(pick_.picked()->value);
    });
    connect(point_, &QAction::triggered, this, &PickActions::addPoint);
    connect(forget_, &QAction::triggered, &pick, &ValuePick::forget);
    connect(&pick, &ValuePick::pickedChanged, this, &PickActions::follow);
    connect(&workbench.session(), &Session::modelChanged, this, &PickActions::follow);
    follow();
}

/// A value that has two points already, a step, gets no third one. Where the mode has no function, the one that all
/// modes share gets the point.
void PickActions::addPoint()
{
    if (!pick_.picked())
        return;
    Session& session = workbench_.session();
    const auto [id, function] =
        workbench_.scenes().editedTransfer().value_or(EditedTransfer{transferId, session.view().appearance.transfer});
    if (const auto added = withPoint(joined(function), pick_.picked()->value))
        session.setTransfer(id, separated(added->function));
}

void PickActions::follow()
{
    pickValue_->setEnabled(workbench_.session().model() != nullptr);
    for (QAction* action : {isovalue_, point_, forget_})
        action->setEnabled(pick_.picked().has_value());
}

} // namespace tetra
