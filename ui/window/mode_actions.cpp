// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/mode_actions.h"

#include "ui/session/message_text.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/palette_commands.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolBar>

namespace tetra {

ModeActions::ModeActions(Workbench& workbench, QMenu& menu, QToolBar& toolBar, QObject* parent)
    : QObject(parent), workbench_(workbench), menu_(menu), toolBar_(toolBar), group_(new QActionGroup(this))
{
    connect(&workbench_.session(), &Session::modelChanged, this, &ModeActions::fill);
    workbench_.session().whenChanged(ViewPart::Mode, this, &ModeActions::check);
    connect(group_, &QActionGroup::triggered, this,
            [this](const QAction* action) { emit chosen(action->data().toString()); });
    menu_.setEnabled(false);
}

void ModeActions::fill()
{
    const bool isOpen = workbench_.session().model() != nullptr;
    if (group_->actions().isEmpty() && isOpen) {
        int key = 1;
        for (const Provided<Renderer>& mode : workbench_.scenes().modes()) {
            auto* action = new QAction(inUsersLanguage(mode.name, mode.names), group_);
            action->setObjectName("action.mode." + QString::fromStdString(mode.id));
            action->setData(QString::fromStdString(mode.id));
            action->setCheckable(true);
            if (key <= 9)
                action->setShortcut(QKeySequence(QString("Alt+%1").arg(key++)));
            action->setToolTip(tr("Show %1 (%2)").arg(action->text(), action->shortcut().toString()));
            setNeed(*action, tr("Open a model first"));
            menu_.addAction(action);
            toolBar_.addAction(action);
        }
        giveMnemonics(menu_);
    }
    menu_.setEnabled(isOpen);
    group_->setEnabled(isOpen);
    check();
}

void ModeActions::check()
{
    const QString mode = QString::fromStdString(workbench_.session().view().appearance.mode);
    for (QAction* action : group_->actions())
        action->setChecked(action->data().toString() == mode);
}

} // namespace tetra
