// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_actions.h"

#include "plugins/widgets/icons.h"
#include "ui/session/message_text.h"
#include "ui/widgets/mnemonics.h"

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QToolBar>

namespace tetra {
namespace {

bool isTaken(const QKeySequence& keys, const QWidget& window)
{
    for (const QAction* action : window.findChildren<QAction*>())
        if (action->shortcuts().contains(keys))
            return true;
    return false;
}

QIcon iconOf(const ToolLook& look)
{
    QList<QPolygonF> lines;
    for (const auto& points : look.icon) {
        QPolygonF line;
        for (const auto& [x, y] : points)
            line.append(QPointF(x, y));
        lines.append(line);
    }
    return lines.isEmpty() ? QIcon() : lineIcon(lines);
}

QString descriptionOf(const PluginHost& host, const std::string& id)
{
    for (const PluginStatus& plugin : host.plugins())
        if (plugin.metadata.id == id)
            return inUsersLanguage(plugin.metadata.description, plugin.metadata.descriptions);
    return {};
}

} // namespace

ToolActions::ToolActions(ToolDesk& desk, Workbench& workbench, QMenu& menu, QToolBar& toolBar)
    : QObject(&menu), desk_(desk), session_(workbench.session())
{
    for (const Provided<Tool>& tool : desk.tools()) {
        const ToolLook look = tool.plugin->look();
        auto* action = new QAction(inUsersLanguage(tool.name, tool.names), &menu);
        action->setObjectName("action.tool." + QString::fromStdString(tool.id));
        action->setCheckable(true);
        action->setIcon(iconOf(look));
        const QKeySequence keys(QString::fromStdString(look.shortcut));
        if (!keys.isEmpty() && !isTaken(keys, *menu.parentWidget()->window()))
            action->setShortcut(keys);
        const QString toolTip = descriptionOf(workbench.host(), tool.id);
        const QString shownKeys = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(shownKeys.isEmpty() ? toolTip : tr("%1 (%2)").arg(toolTip, shownKeys));
        menu.addAction(action);
        toolBar.addAction(action);
        connect(action, &QAction::triggered, this, [this, id = tool.id](bool on) {
            desk_.choose(on ? id : std::string());
            follow();
            if (on)
                emit switchedOn();
        });
        actions_.push_back(action);
    }
    giveMnemonics(menu);
    connect(&desk, &ToolDesk::chosenChanged, this, &ToolActions::follow);
    connect(&session_, &Session::modelChanged, this, &ToolActions::follow);
    follow();
}

void ToolActions::follow()
{
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        actions_[i]->setEnabled(session_.model() != nullptr);
        actions_[i]->setChecked(desk_.tools()[i].id == desk_.chosen());
    }
}

} // namespace tetra
