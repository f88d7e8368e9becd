// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_menu.h"

#include "ui/viewport/value_pick.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"

#include <QMenu>

namespace tetra {

void givePictureMenu(Viewport& viewport, ValuePick& pick, const Actions& actions)
{
    auto* menu = new QMenu(&viewport);
    menu->setObjectName("menu.picture");
    for (QAction* action : actions.picked->actions())
        if (action->objectName() != "action.pickValue") // the click has done that
            menu->addAction(action);
    menu->addSeparator();
    menu->addAction(actions.fit);
    menu->addMenu(actions.lookFrom);
    menu->addSeparator();
    menu->addActions({actions.copyPicture, actions.savePicture});
    viewport.setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(&viewport, &QWidget::customContextMenuRequested, menu,
                     [&viewport, &pick, menu](const QPoint& place) {
                         if (!viewport.scene())
                             return;
                         pick.pickAt(place);
                         menu->popup(viewport.mapToGlobal(place));
                     });
}

} // namespace tetra
