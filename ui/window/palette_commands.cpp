// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/palette_commands.h"

#include "plugins/widgets/number_text.h"
#include "ui/session/accuracy_scale.h"
#include "ui/session/session.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/docks.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QToolButton>

namespace tetra {
namespace {

class PaletteTexts {
    Q_DECLARE_TR_FUNCTIONS(PaletteCommands)
};

constexpr const char* needProperty = "need";

QString joined(const QString& way, const QString& text)
{
    return way.isEmpty() ? text : PaletteTexts::tr("%1: %2").arg(way, text);
}

QString plain(const QString& text)
{
    QString result = withoutMnemonic(text);
    return result.endsWith(QChar(0x2026)) ? result.chopped(1) : result;
}

QString reasonOf(const QAction& action)
{
    if (action.isEnabled())
        return {};
    const QString need = action.property(needProperty).toString();
    return need.isEmpty() ? PaletteTexts::tr("Not possible now") : need;
}

PaletteCommand commandOf(QAction& action, const QString& way)
{
    return {action.objectName(), joined(way, plain(action.text())),
            action.shortcut().toString(QKeySequence::NativeText), reasonOf(action), [action = QPointer(&action)] {
                if (action)
                    action->trigger();
            }};
}

void addMenu(std::vector<PaletteCommand>& commands, QMenu& menu, const QString& way)
{
    emit menu.aboutToShow(); // some are filled only then
    for (QAction* action : menu.actions()) {
        if (action->isSeparator() || action->objectName().startsWith("action.dock."))
            continue;
        if (QMenu* deeper = action->menu())
            addMenu(commands, *deeper, joined(way, plain(action->text())));
        else
            commands.push_back(commandOf(*action, way));
    }
}

/// The panel comes to the front and takes the keys.
void addPanel(std::vector<PaletteCommand>& commands, QDockWidget& dock)
{
    const QAction& toggle = *dock.toggleViewAction();
    commands.push_back({toggle.objectName(),
                        joined(PaletteTexts::tr("Panel"), dock.windowTitle()),
                        {},
                        reasonOf(toggle),
                        [dock = QPointer(&dock)] {
                            if (!dock)
                                return;
                            raiseDock(*dock);
                            if (QWidget* next = dock->widget()->nextInFocusChain())
                                next->setFocus(Qt::TabFocusReason);
                        }});
    for (const QToolButton* button : dock.findChildren<QToolButton*>())
        if (QMenu* menu = button->menu(); menu != nullptr && !menu->isEmpty() && dock.widget()->isEnabled())
            addMenu(commands, *menu, joined(dock.windowTitle(), plain(button->text())));
}

void addAccuracies(std::vector<PaletteCommand>& commands, Session& session)
{
    for (const double percent : accuracyPresets)
        commands.push_back({"accuracy.preset." + QString::number(percent),
                            joined(PaletteTexts::tr("Accuracy"), percentText(percent)),
                            {},
                            session.model() ? QString() : PaletteTexts::tr("Open a model first"),
                            [&session, percent] { session.setError(percent); }});
}

} // namespace

std::vector<PaletteCommand> paletteCommands(QMainWindow& window, Session& session)
{
    std::vector<PaletteCommand> commands;
    for (const QAction* action : window.menuBar()->actions())
        if (QMenu* menu = action->menu())
            addMenu(commands, *menu, plain(action->text()));
    for (QDockWidget* dock : window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
        addPanel(commands, *dock);
    addAccuracies(commands, session);
    return commands;
}

void setNeed(QAction& action, const QString& need)
{
    action.setProperty(needProperty, need);
}

} // namespace tetra
