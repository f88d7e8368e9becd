// SPDX-License-Identifier: GPL-3.0-or-later
// What the buttons and menus of the editor's panel do.
#include "plugins/editors/transferfunction/transfer_canvas.h"
#include "plugins/editors/transferfunction/transfer_panel.h"

#include <tan/transfer.h>

#include <QActionGroup>
#include <QInputDialog>
#include <QLocale>
#include <QMenu>
#include <QToolButton>

namespace tetra {

void TransferPanel::fillViewMenu()
{
    QMenu& menu = *view_->menu();
    menu.addSection(tr("Axis of opacities"));
    auto* axes = new QActionGroup(&menu);
    const auto axis = [&](const char* name, const QString& text, OpacityAxis kind) {
        QAction* action = menu.addAction(text, this, [this, kind] {
            EditorView view = state_.view();
            view.axis = kind;
            state_.setView(view);
        });
        action->setObjectName(QString("transfer.axis.") + name);
        action->setCheckable(true);
        action->setChecked(state_.view().axis == kind);
        axes->addAction(action);
    };
    axis("linear", tr("&Linear"), OpacityAxis::Linear);
    axis("squareRoot", tr("S&quare root"), OpacityAxis::SquareRoot);
    axis("logarithmic", tr("L&ogarithmic: fine near zero"), OpacityAxis::Logarithmic);
    addValueAxes(menu);
    menu.addSeparator();
    const auto look = [&](const char* name, const QString& text, const std::function<void(EditorView&)>& change) {
        QAction* action = menu.addAction(text, this, [this, change] {
            EditorView view = state_.view();
            change(view);
            state_.setView(view);
        });
        action->setObjectName(QString("transfer.zoom.") + name);
        return action;
    };
    look("selection", tr("Zoom to the &selected points"), [this](EditorView& view) {
        const TransferSelection& selection = state_.selection();
        if (selection.size() >= 2)
            view.values = TransferLimits{state_.joinedFunction().points[selection.front()].value,
                                         state_.joinedFunction().points[selection.back()].value};
    });
    look("data", tr("Zoom to the &values of the data"), [this](EditorView& view) { view.values = state_.range(); });
    QAction* all = look("all", tr("Show &all"), [](EditorView& view) {
        view.values.reset();
        view.heights = {};
    });
    all->setShortcut(Qt::Key_Home); // the plot has the key; here it is only shown
    all->setShortcutContext(Qt::WidgetShortcut);
}

void TransferPanel::addValueAxes(QMenu& menu)
{
    menu.addSection(tr("Axis of values"));
    auto* axes = new QActionGroup(&menu);
    const auto axis = [&](const char* name, const QString& text, ValueAxis kind) {
        QAction* action = menu.addAction(text, this, [this, kind] { setValueAxis(kind); });
        action->setObjectName(QString("transfer.valueAxis.") + name);
        action->setCheckable(true);
        axes->addAction(action);
        const auto follow = [this, action, kind] {
            action->setChecked(state_.valueAxis() == kind);
            action->setEnabled(kind == ValueAxis::Linear || !state_.ofLogarithms()); // those go by factors already
        };
        connect(&state_, &EditorState::viewChanged, action, follow);
        connect(&state_, &EditorState::selectionChanged, action, follow); // and after every edit
        follow();
    };
    axis("linear", tr("Li&near"), ValueAxis::Linear);
    axis("logarithmic", tr("Logarithmic: by &factors"), ValueAxis::Logarithmic);
}

void TransferPanel::setValueAxis(ValueAxis axis)
{
    if (!hasPlaces(state_.limits(), axis))
        host_.tell(Message::say(
            "The axis of values stays linear: a logarithmic one has no place for zero and negative values, and the "
            "data or the points begin at %1. Move the points above zero, or choose data with positive values.",
            QLocale().toString(state_.limits().least, 'g', 6).toStdString()));
    EditorView view = state_.view();
    view.valueAxis = hasPlaces(state_.limits(), axis) ? axis : ValueAxis::Linear;
    state_.setView(view);
}

void TransferPanel::setStep(bool on)
{
    const auto point = state_.currentPoint();
    if (!point)
        return;
    const EditedPoint changed =
        on ? withStep(state_.joinedFunction(), *point) : withoutStep(state_.joinedFunction(), *point);
    state_.apply({changed.function, {changed.point}});
}

Status TransferPanel::load(const std::string& text)
{
    auto imported = importTransferFunctions(text, {state_.function(), state_.range()});
    if (!imported)
        return imported.error();
    if (imported->size() == 1)
        take(imported->front());
    else
        offerChoice(*std::move(imported));
    return {};
}

void TransferPanel::take(const ImportedTransfer& imported)
{
    state_.setFunction(imported.function);
    const auto [least, largest] = state_.range();
    if (imported.spread)
        host_.tell(Message::say("The preset covers 0 to 1, and is stretched over the values of the data, %1 to %2.",
                                formatNumber(least), formatNumber(largest)));
}

/// Asks which of the presets that a file holds is meant, and lets the window work on.
void TransferPanel::offerChoice(std::vector<ImportedTransfer> imported)
{
    QStringList names;
    for (std::size_t preset = 0; preset < imported.size(); ++preset)
        names.append(QString("%1  %2").arg(preset + 1).arg(QString::fromStdString(imported[preset].name)));
    auto* choice = new QInputDialog(this);
    choice->setObjectName("transfer.choice");
    choice->setAttribute(Qt::WA_DeleteOnClose);
    choice->setWindowTitle(tr("Load Transfer Function"));
    choice->setLabelText(tr("The file holds several presets:"));
    choice->setOption(QInputDialog::UseListViewForComboBoxItems);
    choice->setComboBoxItems(names);
    connect(choice, &QInputDialog::textValueSelected, this,
            [this, names, presets = std::move(imported)](const QString& name) {
                if (const qsizetype index = names.indexOf(name); index >= 0)
                    take(presets[static_cast<std::size_t>(index)]);
            });
    choice->open();
}

void TransferPanel::save()
{
    host_.saveText(
        this, {"transferSaveDialog", tr("Save Transfer Function"), tr("Transfer functions (*.json)"), "-transfer.json"},
        [this](const std::string&) { return transferFunctionToText(state_.function()); });
}

void TransferPanel::saveForParaview()
{
    host_.saveText(this,
                   {"transferParaviewDialog", tr("Save Transfer Function for ParaView"),
                    tr("ParaView presets (*.json)"), "-paraview.json"},
                   [this](const std::string& name) { return transferFunctionToParaview(state_.function(), name); });
}

} // namespace tetra
