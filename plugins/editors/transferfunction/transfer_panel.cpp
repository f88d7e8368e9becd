// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/transfer_panel.h"

#include "plugins/editors/transferfunction/edit_menu.h"
#include "plugins/editors/transferfunction/point_numbers.h"
#include "plugins/editors/transferfunction/point_table.h"
#include "plugins/editors/transferfunction/preset_popup.h"
#include "plugins/editors/transferfunction/transfer_canvas.h"
#include "plugins/editors/transferfunction/value_text.h"
#include "plugins/widgets/icons.h"
#include "plugins/widgets/scrolled_column.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace tetra {

TransferPanel::TransferPanel(EditorHost& host, QWidget* parent)
    : QWidget(parent), host_(host), state_(host), chooser_(new QComboBox), chooserRow_(new QWidget),
      canvas_(new TransferCanvas(state_)), readOut_(new QLabel), numbers_(new PointNumbers(state_)),
      editMenu_(new EditMenu(state_, this)), presetPopup_(new PresetPopup(state_, this)),
      table_(new PointTable(state_)), add_(new QPushButton(glyphIcon(Glyph::Add), {})),
      remove_(new QPushButton(glyphIcon(Glyph::Remove), {})), step_(new QCheckBox(tr("S&tep"))),
      logarithmic_(new QCheckBox(tr("Lo&garithmic"))), presets_(new QToolButton), edits_(new QToolButton),
      view_(new QToolButton), mask_(new QToolButton), showTable_(new QToolButton), load_(new QToolButton),
      save_(new QToolButton)
{
    setObjectName("transfer");
    nameControls();
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setSpacing(4);
    column->setContentsMargins(7, 5, 7, 5);
    layOutChooser();
    column->addWidget(chooserRow_);
    column->addWidget(canvas_, 1);
    column->addLayout(makeReadOutRow());
    column->addWidget(numbers_);
    addPointTools();
    column->addLayout(makeTools());
    column->addWidget(table_);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    auto* scrolled = new ScrolledColumn(content);
    outer->addWidget(scrolled);
    connect(showTable_, &QToolButton::toggled, scrolled, [this, scrolled](bool on) {
        table_->setVisible(on);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // so that it has its place
        if (on)
            scrolled->ensureWidgetVisible(table_);
    });
    fillViewMenu();
    connectControls();
    showModel();
}

void TransferPanel::nameControls()
{
    const auto name = [](auto* control, const char* id, const QString& text, const QString& tip) {
        control->setObjectName(QString("transfer.") + id);
        if (!text.isEmpty())
            control->setText(text);
        control->setToolTip(tip);
    };
    chooser_->setObjectName("transfer.function");
    chooser_->setToolTip(tr("Transfer function to edit"));
    chooser_->setAccessibleName(tr("Transfer function to edit"));
    name(readOut_, "readOut", {}, tr("Value, opacity, colour and frequency of occurrence, at the pointer"));
    name(step_, "step", {},
         tr("Give the point two sides: one colour and opacity for the values below it, another for those above"));
    name(add_, "add", {}, tr("Add a point after the selected one; or click the curve, or double-click the plot"));
    name(remove_, "remove", {}, tr("Remove the selection (Del)"));
    name(logarithmic_, "logarithmic", {},
         tr("Show how often values occur on a logarithmic scale, so that rare ones are visible"));
    name(presets_, "presets", tr("Presets"), tr("Transfer-function presets"));
    name(edits_, "edits", tr("Change"), tr("Change the selected points, or all"));
    name(view_, "view", tr("View"), tr("How the plot is shown"));
    name(mask_, "mask", tr("Mask"), tr("Show only the values between two draggable lines"));
    name(showTable_, "table.show", tr("Table"), tr("Edit all points in a table"));
    name(load_, "load", tr("Load…"), tr("Load a transfer function: TAn's own, or ParaView presets (JSON or XML)"));
    name(save_, "save", tr("Save…"), tr("Save the transfer function as a JSON file, which “tan render” also accepts"));
    add_->setAccessibleName(tr("Add a point"));
    remove_->setAccessibleName(tr("Remove the selection"));
    readOut_->setTextFormat(Qt::RichText);
    readOut_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    mask_->setCheckable(true);
    showTable_->setCheckable(true);
    logarithmic_->setChecked(true);
    table_->hide();
}

/// Above the plot, where the rendering mode has several functions.
void TransferPanel::layOutChooser()
{
    constexpr int leastLetters = 12; // names are the renderer's, and as long as it likes
    auto* row = new QHBoxLayout(chooserRow_);
    row->setContentsMargins({});
    auto* label = new QLabel(tr("Fun&ction"));
    label->setBuddy(chooser_);
    chooser_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    chooser_->setMinimumContentsLength(leastLetters);
    row->addWidget(label);
    row->addWidget(chooser_, 1);
}

/// Below the plot: what is at the pointer, and how its background is scaled.
QBoxLayout* TransferPanel::makeReadOutRow()
{
    auto* row = new QHBoxLayout;
    row->addWidget(readOut_, 1);
    row->addWidget(logarithmic_);
    return row;
}

/// Before the unit distance, so that the panel is low enough for small screens.
void TransferPanel::addPointTools()
{
    int place = 0;
    for (QWidget* control : std::initializer_list<QWidget*>{add_, remove_, step_, mask_})
        numbers_->lowerRow().insertWidget(place++, control);
    numbers_->lowerRow().insertSpacing(place, 4);
}

QBoxLayout* TransferPanel::makeTools()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(3);
    edits_->setPopupMode(QToolButton::InstantPopup);
    edits_->setMenu(editMenu_);
    view_->setPopupMode(QToolButton::InstantPopup);
    view_->setMenu(new QMenu(view_));
    save_->setPopupMode(QToolButton::MenuButtonPopup);
    save_->setMenu(new QMenu(save_));
    for (QToolButton* button : {presets_, edits_, view_, showTable_})
        row->addWidget(button);
    row->addStretch();
    row->addWidget(load_);
    row->addWidget(save_);
    return row;
}

void TransferPanel::connectControls()
{
    connect(chooser_, &QComboBox::activated, this, [this](int index) {
        state_.edit(chooser_->itemData(index).toString().toStdString());
        showFunction();
    });
    connect(add_, &QPushButton::clicked, this, [this] { addPoint(state_, std::nullopt); });
    connect(remove_, &QPushButton::clicked, this, [this] { state_.removeCurrent(); });
    connect(step_, &QCheckBox::clicked, this, &TransferPanel::setStep);
    connect(logarithmic_, &QCheckBox::toggled, this, [this](bool on) {
        EditorView view = state_.view();
        view.logarithmicCounts = on;
        state_.setView(view);
    });
    connect(presets_, &QToolButton::clicked, this, [this] { presetPopup_->showAt(*presets_); });
    connect(mask_, &QToolButton::clicked, this, [this](bool on) { setMasked(state_, on); });
    connect(load_, &QToolButton::clicked, this, [this] {
        host_.loadText(this,
                       {"transferDialog", tr("Load Transfer Function"), tr("Transfer functions (*.json *.xml)"), {}},
                       [this](const std::string& text) { return load(text); });
    });
    connect(save_, &QToolButton::clicked, this, &TransferPanel::save);
    QAction* paraview = save_->menu()->addAction(tr("Save for &ParaView…"), this, &TransferPanel::saveForParaview);
    paraview->setObjectName("transfer.save.paraview");
    connect(canvas_, &QWidget::customContextMenuRequested, this, &TransferPanel::openEditMenu);
    connect(canvas_, &TransferCanvas::pointedChanged, this, &TransferPanel::showReadOut);
    connect(canvas_, &TransferCanvas::colourWanted, numbers_, &PointNumbers::askForColour);
    connect(editMenu_, &EditMenu::colourWanted, numbers_, &PointNumbers::askForColour);
    connect(
        edits_->menu(), &QMenu::aboutToHide, this, [this] { editMenu_->setPlace(std::nullopt); }, Qt::QueuedConnection);
    connect(&state_, &EditorState::selectionChanged, this, &TransferPanel::showSelection);
    host_.whenChanged(this, [this](EditorChange change) {
        switch (change) {
        case EditorChange::Model: return showModel();
        case EditorChange::Value:
        case EditorChange::Isovalues: return showFunction();
        case EditorChange::Mesh: return canvas_->update();
        case EditorChange::Picked: return showPicked();
        }
    });
}

void TransferPanel::showModel()
{
    setEnabled(host_.hasModel());
    state_.followFunctions();
    state_.setCurrent({});
    state_.setView({{}, {}, state_.view().axis, state_.view().valueAxis, state_.view().logarithmicCounts});
    numbers_->showModel();
    showFunction();
}

/// Filled anew only with others than it has: it may be open.
void TransferPanel::showChooser()
{
    const std::vector<Parameter>& functions = state_.functions();
    const auto isEntry = [this, row = 0](const Parameter& function) mutable {
        const int entry = row++;
        return chooser_->itemData(entry).toString().toStdString() == function.id &&
               chooser_->itemText(entry).toStdString() == function.label;
    };
    const QSignalBlocker blocker(chooser_);
    if (chooser_->count() != static_cast<int>(functions.size()) || !std::ranges::all_of(functions, isEntry)) {
        chooser_->clear();
        for (const Parameter& function : functions) {
            chooser_->addItem(QString::fromStdString(function.label), QString::fromStdString(function.id));
            chooser_->setItemData(chooser_->count() - 1, QString::fromStdString(function.explanation), Qt::ToolTipRole);
        }
    }
    chooser_->setCurrentIndex(chooser_->findData(QString::fromStdString(state_.edited())));
    chooserRow_->setVisible(functions.size() > 1);
}

void TransferPanel::showFunction()
{
    state_.followFunctions();
    showChooser();
    state_.forgetWhatIsGone();
    table_->refresh();
    mask_->setChecked(state_.joinedFunction().mask.has_value());
    canvas_->update();
}

void TransferPanel::showSelection()
{
    const auto point = state_.currentPoint();
    step_->setEnabled(point.has_value());
    step_->setChecked(point && isOnStep(state_.joinedFunction(), *point));
    remove_->setEnabled(state_.current().kind != EditorItem::Kind::None);
    numbers_->showSelection();
    showReadOut();
}

void TransferPanel::showPicked()
{
    editMenu_->enableWhatIsPossible();
    canvas_->update();
    showReadOut();
}

/// At the pointer; else of what is selected or picked in the picture, so that the keyboard has it, too.
void TransferPanel::showReadOut()
{
    auto value = canvas_->pointed();
    if (!value)
        value = state_.valueOf(state_.current());
    if (!value)
        value = pickedValue(state_);
    readOut_->setText(value && host_.hasModel() ? readOutOf(state_, *value) : QString("&nbsp;"));
    readOut_->setAccessibleName(value && host_.hasModel() ? plainReadOutOf(state_, *value) : tr("Read-out"));
}

void TransferPanel::openEditMenu(QPoint place)
{
    const TransferPlot plot = canvas_->plot();
    editMenu_->setPlace(plot.area.contains(place) ? std::optional(plot.valueAt(place.x())) : std::nullopt);
    editMenu_->popup(canvas_->mapToGlobal(place));
}

} // namespace tetra
