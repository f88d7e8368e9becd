// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/transfer_panel.h"

#include "core/transfer/colour_map.h"
#include "core/transfer/default_transfer_functions.h"
#include "core/transfer/transfer_import.h"
#include "core/transfer/transfer_text.h"
#include "plugins/editors/transferfunction/colour_map_icon.h"
#include "plugins/editors/transferfunction/transfer_canvas.h"
#include "plugins/widgets/colour_button.h"
#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/icons.h"
#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "plugins/widgets/value_box.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace tetra {
namespace {

constexpr double opacityFactor = 1.25;
/// Unit distances that are offered, in diagonals of the domain.
constexpr double leastUnit = 1e-4;
constexpr double largestUnit = 10;

void showNumber(ValueBox& box, double value)
{
    const QSignalBlocker blocker(box);
    box.setValue(value);
}

QAction* newAction(QMenu& menu, const char* name, const QString& text)
{
    QAction* action = menu.addAction(text);
    action->setObjectName(QString("transfer.") + name);
    return action;
}

} // namespace

TransferPanel::TransferPanel(EditorHost& host, QWidget* parent)
    : QWidget(parent), host_(host), canvas_(new TransferCanvas(host)), value_(new ValueBox), opacity_(new ValueBox),
      colour_(new ColourButton), step_(new QCheckBox(tr("S&tep"))),
      add_(new QPushButton(glyphIcon(Glyph::Add), tr("Ad&d"))),
      remove_(new QPushButton(glyphIcon(Glyph::Remove), tr("Remove"))), unitDistance_(new ValueBox),
      logarithmic_(new QCheckBox(tr("Lo&garithmic"))), presets_(new QToolButton), edits_(new QToolButton),
      load_(new QToolButton), save_(new QToolButton)
{
    setObjectName("transfer");
    nameControls();
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->addWidget(canvas_, 1);
    auto* grid = new QGridLayout;
    addNumbers(*grid);
    column->addLayout(grid);
    column->addWidget(makeTools());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(content));
    fillPresets();
    fillEdits();
    connectControls();
    showModel();
}

void TransferPanel::nameControls()
{
    value_->setObjectName("transfer.value");
    value_->setAccessibleName(tr("Value of the point"));
    value_->setToolTip(tr("Value of the selected point, in the units of the data"));
    opacity_->setObjectName("transfer.opacity");
    opacity_->setAccessibleName(tr("Opacity of the point"));
    opacity_->setToolTip(tr("Opacity of the selected point, in percent of the light that a unit distance takes away"));
    opacity_->setValueRange(0, 100);
    opacity_->setDecimals(2);
    opacity_->setSuffix(tr(" %"));
    colour_->setObjectName("transfer.colour");
    colour_->setToolTip(tr("Colour of the selected point"));
    step_->setObjectName("transfer.step");
    step_->setToolTip(tr("Give the point two sides: what lies below its value ends there, and what lies above begins"));
    add_->setObjectName("transfer.add");
    add_->setToolTip(tr("Add a point after the selected one, or double click in the plot"));
    remove_->setObjectName("transfer.remove");
    remove_->setToolTip(tr("Remove the selected point (Del)"));
    unitDistance_->setObjectName("transfer.unitDistance");
    unitDistance_->setAccessibleName(tr("Unit distance"));
    unitDistance_->setToolTip(tr("The thickness, in the units of the data, that a layer must have for the opacities to "
                                 "hold: less makes everything denser"));
    logarithmic_->setObjectName("transfer.logarithmic");
    logarithmic_->setToolTip(tr("Show how often values occur on a logarithmic scale, so that rare ones are seen"));
    logarithmic_->setChecked(true);
    presets_->setObjectName("transfer.presets");
    presets_->setText(tr("Presets"));
    presets_->setToolTip(tr("Transfer functions to begin with"));
    edits_->setObjectName("transfer.edits");
    edits_->setText(tr("Change"));
    edits_->setToolTip(tr("Change all points"));
    load_->setObjectName("transfer.load");
    load_->setText(tr("Load…"));
    load_->setToolTip(tr("Take a transfer function from a file: one of TAn or presets of ParaView (JSON or XML)"));
    save_->setObjectName("transfer.save");
    save_->setText(tr("Save…"));
    save_->setToolTip(tr("Save the transfer function as a JSON file, which “tan render” takes, too"));
    for (ValueBox* box : {value_, opacity_, unitDistance_}) {
        box->setMinimumWidth(1); // as wide as the panel allows
        new GestureWatcher(box, host_);
    }
}

void TransferPanel::addNumbers(QGridLayout& grid)
{
    auto* valueLabel = new QLabel(tr("Val&ue"));
    valueLabel->setBuddy(value_);
    auto* opacityLabel = new QLabel(tr("O&pacity"));
    opacityLabel->setBuddy(opacity_);
    auto* unitLabel = new QLabel(tr("U&nit distance"));
    unitLabel->setBuddy(unitDistance_);
    grid.addWidget(valueLabel, 0, 0);
    grid.addWidget(value_, 0, 1);
    grid.addWidget(opacityLabel, 0, 2);
    grid.addWidget(opacity_, 0, 3);
    grid.addWidget(colour_, 0, 4);
    auto* points = new QHBoxLayout;
    points->addWidget(add_);
    points->addWidget(remove_);
    points->addWidget(step_);
    points->addStretch();
    points->addWidget(logarithmic_);
    grid.addLayout(points, 1, 0, 1, 5);
    auto* unit = new QHBoxLayout;
    unit->addWidget(unitLabel);
    unit->addWidget(unitDistance_, 1);
    grid.addLayout(unit, 2, 0, 1, 5);
    grid.setColumnStretch(1, 1);
    grid.setColumnStretch(3, 1);
}

QWidget* TransferPanel::makeTools()
{
    auto* tools = new QWidget;
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins({});
    for (QToolButton* button : {presets_, edits_}) {
        button->setPopupMode(QToolButton::InstantPopup);
        button->setMenu(new QMenu(button));
    }
    save_->setPopupMode(QToolButton::MenuButtonPopup);
    save_->setMenu(new QMenu(save_));
    row->addWidget(presets_);
    row->addWidget(edits_);
    row->addStretch();
    row->addWidget(load_);
    row->addWidget(save_);
    return tools;
}

void TransferPanel::fillPresets()
{
    const auto add = [this](const char* name, const QString& text, auto make) {
        connect(newAction(*presets_->menu(), name, text), &QAction::triggered, this, [this, make] {
            const ValueRange range = host_.range();
            host_.setFunction(make(range.minimum, range.maximum, function().unitDistance));
        });
    };
    add("preset.sequential", tr("&Sequential: opaque where values are large"), &sequentialTransferFunction);
    add("preset.diverging", tr("&Diverging: opaque at both ends"), &divergingTransferFunction);
    presets_->menu()->addSection(tr("Colours alone"));
    for (const ColourMap& map : colourMaps()) {
        QAction* action =
            newAction(*presets_->menu(), QString::fromStdString("colours." + map.id).toUtf8(), colourMapName(map.id));
        action->setIcon(colourMapIcon(map));
        action->setToolTip(QString::fromStdString(map.source));
        connect(action, &QAction::triggered, this, [this, &map] {
            host_.setFunction(withColourMap(function(), map, {host_.range().minimum, host_.range().maximum}));
        });
    }
    presets_->menu()->setToolTipsVisible(true);
}

void TransferPanel::fillEdits()
{
    const auto add = [this](const char* name, const QString& text, auto change) {
        connect(newAction(*edits_->menu(), name, text), &QAction::triggered, this,
                [this, change] { host_.setFunction(change(function())); });
    };
    const auto range = [this] { return TransferLimits{host_.range().minimum, host_.range().maximum}; };
    add("change.denser", tr("&More opaque"),
        [](const TransferFunction& old) { return withScaledOpacity(old, opacityFactor); });
    add("change.thinner", tr("&Less opaque"),
        [](const TransferFunction& old) { return withScaledOpacity(old, 1 / opacityFactor); });
    add("change.mirror", tr("Swap &ends"), [range](const TransferFunction& old) { return mirrored(old, range()); });
    add("change.spread", tr("Spread over all &values"),
        [range](const TransferFunction& old) { return spreadOver(old, range()); });
}

const TransferFunction& TransferPanel::function() const
{
    return host_.function();
}

void TransferPanel::connectControls()
{
    const auto edited = [this](double value, double opacity) {
        if (const auto point = canvas_->selected())
            host_.setFunction(withMovedPoint(function(), *point, value, opacity, canvas_->plot().limits));
        showFunction();
    };
    connect(value_, &QDoubleSpinBox::valueChanged, this, [this, edited](double value) {
        if (const auto point = canvas_->selected())
            edited(value, function().points[*point].opacity);
    });
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, [this, edited](double percent) {
        if (const auto point = canvas_->selected())
            edited(function().points[*point].value, percent / 100);
    });
    connect(colour_, &ColourButton::colourChosen, this, [this](const QColor& colour) {
        const std::array<float, 3> channels{static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                                            static_cast<float>(colour.blueF())};
        if (const auto point = canvas_->selected())
            host_.setFunction(withColour(function(), *point, channels));
    });
    connect(step_, &QCheckBox::clicked, this, [this](bool on) {
        const auto point = canvas_->selected();
        if (!point)
            return;
        const EditedTransfer changed = on ? withStep(function(), *point) : withoutStep(function(), *point);
        host_.setFunction(changed.function);
        canvas_->select(changed.point);
    });
    connect(add_, &QPushButton::clicked, this, &TransferPanel::addPoint);
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (const auto point = canvas_->selected())
            host_.setFunction(withoutPoint(function(), *point));
    });
    connect(unitDistance_, &QDoubleSpinBox::valueChanged, this,
            [this](double distance) { host_.setFunction(withUnitDistance(function(), distance)); });
    connect(logarithmic_, &QCheckBox::toggled, canvas_, &TransferCanvas::setLogarithmic);
    connect(load_, &QToolButton::clicked, this, [this] {
        host_.loadText(this,
                       {"transferDialog", tr("Load Transfer Function"), tr("Transfer functions (*.json *.xml)"), {}},
                       [this](const std::string& text) { return load(text); });
    });
    connect(save_, &QToolButton::clicked, this, &TransferPanel::save);
    connect(newAction(*save_->menu(), "save.paraview", tr("Save for &ParaView…")), &QAction::triggered, this,
            &TransferPanel::saveForParaview);
    connect(canvas_, &TransferCanvas::selectionChanged, this, &TransferPanel::showFunction);
    host_.whenChanged(this, [this](EditorChange change) {
        switch (change) {
        case EditorChange::Model: return showModel();
        case EditorChange::Function: return canvas_->refresh();
        case EditorChange::Isovalues:
        case EditorChange::Mesh: return canvas_->update();
        }
    });
}

/// Halfway to the next point, or in the middle of the values.
void TransferPanel::addPoint()
{
    const auto [least, largest] = canvas_->plot().limits;
    const auto& points = function().points;
    double value = (least + largest) / 2;
    if (const auto point = canvas_->selected()) {
        const double from = points[*point].value;
        const auto next = std::ranges::upper_bound(points, from, {}, &TransferPoint::value);
        value = (from + (next != points.end() ? next->value : largest)) / 2;
    }
    if (const auto added = withPoint(function(), value)) {
        host_.setFunction(added->function);
        canvas_->select(added->point);
    }
}

Status TransferPanel::load(const std::string& text)
{
    const ValueRange range = host_.range();
    auto imported = importTransferFunctions(text, {function(), TransferLimits{range.minimum, range.maximum}});
    if (!imported)
        return imported.error();
    if (imported->size() == 1)
        host_.setFunction(imported->front().function);
    else
        offerChoice(*std::move(imported));
    return {};
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
                    host_.setFunction(presets[static_cast<std::size_t>(index)].function);
            });
    choice->open();
}

void TransferPanel::save()
{
    host_.saveText(
        this, {"transferSaveDialog", tr("Save Transfer Function"), tr("Transfer functions (*.json)"), "-transfer.json"},
        [this](const std::string&) { return transferFunctionToText(function()); });
}

void TransferPanel::saveForParaview()
{
    host_.saveText(this,
                   {"transferParaviewDialog", tr("Save Transfer Function for ParaView"),
                    tr("ParaView presets (*.json)"), "-paraview.json"},
                   [this](const std::string& name) { return transferFunctionToParaview(function(), name); });
}

void TransferPanel::showModel()
{
    setEnabled(host_.hasModel());
    canvas_->select(std::nullopt);
    if (host_.hasModel()) {
        const double diagonal = host_.diagonal() > 0 ? host_.diagonal() : 1;
        const QSignalBlocker blocker(unitDistance_);
        unitDistance_->setValueRange(leastUnit * diagonal, largestUnit * diagonal);
        unitDistance_->setDecimals(std::max(unitDistance_->decimals(), decimalsFor(leastUnit * diagonal)));
        unitDistance_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    }
    showFunction();
}

void TransferPanel::showFunction()
{
    const auto point = canvas_->selected();
    for (QWidget* control : std::initializer_list<QWidget*>{value_, opacity_, colour_, step_, remove_})
        control->setEnabled(point.has_value());
    const auto [least, largest] = canvas_->plot().limits;
    const QSignalBlocker blocker(value_);
    value_->setValueRange(least, largest);
    step_->setChecked(point && isOnStep(function(), *point));
    if (!point)
        colour_->setColour(palette().color(QPalette::Button));
    if (point) {
        const TransferPoint& shown = function().points[*point];
        showNumber(*value_, shown.value);
        showNumber(*opacity_, 100.0 * shown.opacity);
        colour_->setColour(QColor::fromRgbF(shown.colour[0], shown.colour[1], shown.colour[2]));
    }
    showNumber(*unitDistance_, function().unitDistance);
}

} // namespace tetra
