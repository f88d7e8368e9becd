// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/palette_commands.h"

#include "core/view/accuracy_scale.h"
#include "plugins/widgets/number_text.h"
#include "ui/session/message_text.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/docks.h"
#include "ui/workbench/workbench.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QScrollArea>
#include <QToolButton>

#include <algorithm>
#include <map>
#include <set>

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

/// Nothing to run yet.
PaletteCommand namedCommand(const QString& name, const QString& way, const QString& own)
{
    PaletteCommand command;
    command.name = name;
    command.text = joined(way, own);
    command.ownStart = command.text.size() - own.size();
    return command;
}

PaletteCommand commandOf(QAction& action, const QString& way)
{
    PaletteCommand command = namedCommand(action.objectName(), way, plain(action.text()));
    command.explanation = action.toolTip();
    command.keys = action.shortcut().toString(QKeySequence::NativeText);
    command.reason = reasonOf(action);
    command.run = [action = QPointer(&action)] {
        if (action)
            action->trigger();
    };
    return command;
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
    PaletteCommand& command =
        commands.emplace_back(namedCommand(toggle.objectName(), PaletteTexts::tr("Panel"), dock.windowTitle()));
    command.reason = reasonOf(toggle);
    command.run = [dock = QPointer(&dock)] {
        if (!dock)
            return;
        raiseDock(*dock);
        if (QWidget* next = dock->widget()->nextInFocusChain())
            next->setFocus(Qt::TabFocusReason);
    };
    for (const QToolButton* button : dock.findChildren<QToolButton*>())
        if (QMenu* menu = button->menu(); menu != nullptr && !menu->isEmpty() && dock.widget()->isEnabled())
            addMenu(commands, *menu, joined(dock.windowTitle(), plain(button->text())));
}

void addAccuracies(std::vector<PaletteCommand>& commands, Session& session)
{
    for (const double percent : accuracyPresets) {
        PaletteCommand& command = commands.emplace_back(namedCommand(
            "accuracy.preset." + QString::number(percent), PaletteTexts::tr("Accuracy"), percentText(percent)));
        command.reason = session.model() ? QString() : PaletteTexts::tr("Open a model first");
        command.run = [&session, percent] { session.setError(percent); };
    }
}

/// What the labels of a panel call its controls.
std::map<const QWidget*, QString> labelsOf(const QWidget& panel)
{
    std::map<const QWidget*, QString> labels;
    for (const QLabel* label : panel.findChildren<QLabel*>())
        if (label->buddy() != nullptr)
            labels[label->buddy()] = plain(label->text());
    return labels;
}

/// A control that takes the keys, named by its label, by what stands on it, or by what is read out of it.
QString settingName(const QWidget& control, const std::map<const QWidget*, QString>& labels)
{
    if ((control.focusPolicy() & Qt::TabFocus) == 0 || control.focusProxy() != nullptr)
        return {};
    if (const auto label = labels.find(&control); label != labels.end())
        return label->second;
    if (const auto* button = qobject_cast<const QAbstractButton*>(&control); button != nullptr)
        if (const QString text = plain(button->text()); !text.isEmpty())
            return text;
    return control.accessibleName();
}

/// The panel comes to the front, scrolled to the control, which gets the keys.
void goTo(QDockWidget& dock, QWidget& control)
{
    raiseDock(dock);
    const auto show = [control = QPointer(&control)] {
        if (!control)
            return;
        control->setFocus(Qt::TabFocusReason);
        for (QWidget* around = control; around != nullptr; around = around->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(around))
                area->ensureWidgetVisible(control);
    };
    show();
    QMetaObject::invokeMethod(&control, show, Qt::QueuedConnection); // a panel that was hidden has its size only then
}

/// What is set in a panel, as far as it is shown there.
void addSettings(std::vector<PaletteCommand>& commands, QDockWidget& dock, const QString& need)
{
    QWidget& panel = *dock.widget();
    const auto labels = labelsOf(panel);
    for (QWidget* control : panel.findChildren<QWidget*>()) {
        const QString own = settingName(*control, labels);
        if (own.isEmpty() || !control->isVisibleTo(&panel))
            continue;
        PaletteCommand& command = commands.emplace_back(namedCommand(control->objectName(), dock.windowTitle(), own));
        command.isSetting = true;
        command.explanation = control->toolTip();
        if (const QString spoken = control->accessibleName(); spoken != own && !spoken.isEmpty())
            command.spoken = joined(dock.windowTitle(), spoken);
        if (!control->isEnabledTo(&dock))
            command.reason = need;
        command.run = [dock = QPointer(&dock), control = QPointer(control)] {
            if (dock && control)
                goTo(*dock, *control);
        };
    }
}

/// What has an editor of its own is found there.
bool isSetInForms(const Parameter& parameter)
{
    const ParameterValue& value = parameter.defaultValue;
    return std::holds_alternative<bool>(value) || std::holds_alternative<std::int64_t>(value) ||
           std::holds_alternative<double>(value) || std::holds_alternative<std::string>(value) ||
           std::holds_alternative<Colour>(value) || std::holds_alternative<Eigen::Vector3d>(value);
}

/// Settings that the present mode lacks, and which modes have them.
void addOtherModes(std::vector<PaletteCommand>& commands, const QString& panel, Workbench& workbench)
{
    std::map<QString, QStringList> modes; // by what is set
    QStringList ofPresent;
    for (const Provided<Renderer>& mode : workbench.scenes().modes())
        for (const Parameter& parameter : mode.plugin->parameters({})) {
            const QString label = translatedText(parameter.label);
            if (mode.id == workbench.session().view().appearance.mode)
                ofPresent.append(label);
            else if (isSetInForms(parameter))
                modes[label].append(inUsersLanguage(mode.name, mode.names));
        }
    for (const auto& [own, names] : modes) {
        if (ofPresent.contains(own))
            continue;
        PaletteCommand& command = commands.emplace_back(namedCommand({}, panel, own));
        command.isSetting = true;
        command.reason = PaletteTexts::tr("Only in %1").arg(names.join(", "));
    }
}

/// The first of those that read the same stays: a slider and its box, a button and the menu that it belongs to.
void removeRepeated(std::vector<PaletteCommand>& commands)
{
    std::set<QString> seen;
    std::erase_if(commands, [&](const PaletteCommand& command) {
        return !seen.insert(command.text).second && command.isSetting;
    });
}

} // namespace

std::vector<PaletteCommand> paletteCommands(QMainWindow& window, Workbench& workbench)
{
    std::vector<PaletteCommand> commands;
    for (const QAction* action : window.menuBar()->actions())
        if (QMenu* menu = action->menu())
            addMenu(commands, *menu, plain(action->text()));
    const auto docks = window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly);
    for (QDockWidget* dock : docks)
        addPanel(commands, *dock);
    addAccuracies(commands, workbench.session());
    const QString need =
        workbench.session().model() ? PaletteTexts::tr("Not possible now") : PaletteTexts::tr("Open a model first");
    for (QDockWidget* dock : docks) {
        addSettings(commands, *dock, need);
        if (dock->objectName() == "dock.rendering")
            addOtherModes(commands, dock->windowTitle(), workbench);
    }
    removeRepeated(commands);
    return commands;
}

void setNeed(QAction& action, const QString& need)
{
    action.setProperty(needProperty, need);
}

} // namespace tetra
