// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/region_panel.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/scrolled_column.h"
#include "plugins/widgets/value_box.h"
#include "ui/panels/accuracy_inputs.h"
#include "ui/session/logarithm_text.h"
#include "ui/widgets/value_slider.h"
#include "ui/widgets/vector_input.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

constexpr std::array borders{WindowBorder::Clipped, WindowBorder::Intersecting, WindowBorder::Contained};

} // namespace

RegionPanel::RegionPanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), window_(new QCheckBox(tr("&Only a crop box"))), windowSettings_(new QWidget),
      border_(new QComboBox), values_(new QCheckBox(tr("&Limit to a range of values"))), valueSettings_(new QWidget),
      least_(new ValueSlider("region.least", session)), largest_(new ValueSlider("region.largest", session)),
      reset_(new QPushButton(tr("&Reset to Whole Domain"))),
      range_(new QCheckBox(tr("All tetrahedra in a range of &errors"))), rangeSettings_(new QWidget)
{
    setObjectName("region");
    window_->setObjectName("region.window");
    window_->setToolTip(tr("Show only the part of the domain in a box (W)"));
    values_->setObjectName("region.values");
    values_->setToolTip(tr("Show only tetrahedra that can contain a value in a range. Isosurfaces of other values "
                           "disappear, or are shown only in part."));
    range_->setObjectName("region.range");
    range_->setToolTip(
        tr("Overlay the tetrahedra of every mesh between two errors, as surfaces. The crop box does not cut them."));
    windowSettings_->setLayout(makeWindow());
    valueSettings_->setLayout(makeValues());
    rangeSettings_->setLayout(makeRange());

    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    auto* head = new QHBoxLayout;
    head->addWidget(window_, 1);
    head->addWidget(reset_);
    layout->addLayout(head);
    layout->addWidget(windowSettings_);
    layout->addSpacing(6);
    layout->addWidget(values_);
    layout->addWidget(valueSettings_);
    layout->addSpacing(6);
    layout->addWidget(range_);
    layout->addWidget(rangeSettings_);
    layout->addStretch();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(content));

    connect(window_, &QCheckBox::clicked, this,
            [this](bool on) { editWindow([on](WindowState& window) { window.enabled = on; }); });
    connect(values_, &QCheckBox::clicked, this,
            [this](bool on) { editValues([on](ValueFilter& values) { values.enabled = on; }); });
    connect(range_, &QCheckBox::clicked, this,
            [this](bool on) { editRange([on](RangeState& range) { range.enabled = on; }); });
    connect(&session_, &Session::modelChanged, this, &RegionPanel::showModel);
    session_.whenChanged(ViewPart::Query, this, &RegionPanel::showQuery);
    showModel();
}

/// Apply a change and show what the session made of it.
template <class Change> void RegionPanel::editWindow(Change change)
{
    WindowState changed = session_.view().query.window;
    change(changed);
    session_.setWindow(changed);
    showQuery();
}

template <class Change> void RegionPanel::editValues(Change change)
{
    ValueFilter changed = session_.view().query.values;
    change(changed);
    session_.setValueFilter(changed);
    showQuery();
}

template <class Change> void RegionPanel::editRange(Change change)
{
    RangeState changed = session_.view().query.range;
    change(changed);
    session_.setRange(changed);
    showQuery();
}

QLayout* RegionPanel::makeWindow()
{
    auto* grid = new QGridLayout;
    grid->setContentsMargins({});
    addAxisNames(*grid, 0);
    const QString toolTip = tr("Corners of the crop box, in data coordinates");
    from_ = new VectorInput("region.from", tr("Fro&m"), toolTip, session_, *grid, 1, this);
    to_ = new VectorInput("region.to", tr("&To"), toolTip, session_, *grid, 2, this);
    border_->setObjectName("region.border");
    border_->addItems({tr("Cut exactly"), tr("Keep tetrahedra that touch it"), tr("Keep tetrahedra inside")});
    border_->setAccessibleName(tr("Tetrahedra at the border"));
    border_->setToolTip(
        tr("How tetrahedra at the border of the crop box are treated: cut exactly there, or kept or left out whole"));
    border_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto* label = new QLabel(tr("&Border"));
    label->setBuddy(border_);
    grid->addWidget(label, 3, 0);
    grid->addWidget(border_, 3, 1, 1, 3);
    reset_->setObjectName("region.reset");
    reset_->setToolTip(tr("Make the crop box as large as the domain"));

    connect(from_, &VectorInput::edited, this, [this](const Eigen::Vector3d& from) {
        editWindow([&from](WindowState& window) { window.window.box.least = from; });
    });
    connect(to_, &VectorInput::edited, this, [this](const Eigen::Vector3d& to) {
        editWindow([&to](WindowState& window) { window.window.box.largest = to; });
    });
    connect(border_, &QComboBox::activated, this, [this](int index) {
        editWindow([index](WindowState& window) { window.window.border = borders[static_cast<std::size_t>(index)]; });
    });
    connect(reset_, &QPushButton::clicked, this, [this] {
        const Eigen::AlignedBox3d& bounds = session_.model()->description().bounds;
        editWindow([&bounds](WindowState& window) { window.window.box = {bounds.min(), bounds.max()}; });
    });
    return grid;
}

QLayout* RegionPanel::makeValues()
{
    auto* grid = new QGridLayout;
    grid->setContentsMargins({});
    grid->setColumnStretch(1, 1);
    const std::array<std::pair<ValueSlider*, QString>, 2> rows{{{least_, tr("&Smallest")}, {largest_, tr("&Largest")}}};
    for (int row = 0; row < 2; ++row) {
        const auto& [slider, text] = rows[static_cast<std::size_t>(row)];
        auto* label = new QLabel(text);
        label->setBuddy(slider);
        grid->addWidget(label, row, 0);
        grid->addWidget(slider, row, 1);
    }
    connect(least_, &ValueSlider::edited, this,
            [this](double value) { editValues([value](ValueFilter& values) { values.least = value; }); });
    connect(largest_, &ValueSlider::edited, this,
            [this](double value) { editValues([value](ValueFilter& values) { values.largest = value; }); });
    return grid;
}

/// Two errors, and what of the tetrahedra between them is chosen: that only filters what is there.
QLayout* RegionPanel::makeRange()
{
    struct Row {
        const char* name;
        double RangeState::*percent;
        QString label;
        QString accessibleName;
        QString toolTip;
    };
    const QString noLimit = tr("in percent of the value range; 100 means no limit");
    const std::array<Row, 6> rows{{
        {"fine", &RangeState::fine, tr("F&inest"), tr("Smallest error of the range"),
         tr("The mesh of this error is the finest of the range, in percent of the value range")},
        {"coarse", &RangeState::coarse, tr("&Coarsest"), tr("Largest error of the range"),
         tr("The mesh of this error is the coarsest of the range, in percent of the value range")},
        {"bornAbove", &RangeState::bornAbove, tr("&Appear above"), tr("Appear above"),
         tr("Only tetrahedra that first appear above this error, in percent of the value range")},
        {"bornTo", &RangeState::bornTo, tr("Appear &up to"), tr("Appear up to"),
         tr("Only tetrahedra that first appear at or below this error, %1").arg(noLimit)},
        {"diedFrom", &RangeState::diedFrom, tr("&Disappear from"), tr("Disappear from"),
         tr("Only tetrahedra that are replaced at this error or a larger one, in percent of the value range")},
        {"diedTo", &RangeState::diedTo, tr("Disap&pear up to"), tr("Disappear up to"),
         tr("Only tetrahedra that are still in the mesh of this error, %1").arg(noLimit)},
    }};
    auto* grid = new QGridLayout;
    grid->setContentsMargins({});
    grid->setColumnStretch(1, 1);
    for (const Row& row : rows) {
        const RangeInput input{row.percent, new AccuracySlider, new AccuracyBox};
        input.slider->setObjectName(QString("region.%1.slider").arg(row.name));
        input.box->setObjectName(QString("region.%1.box").arg(row.name));
        for (QWidget* widget : std::initializer_list<QWidget*>{input.slider, input.box}) {
            widget->setAccessibleName(row.accessibleName);
            widget->setToolTip(row.toolTip);
            new GestureWatcher(widget, session_);
        }
        const auto choose = [this, member = row.percent](double percent) {
            editRange([member, percent](RangeState& range) { range.*member = percent; });
        };
        connect(input.slider, &AccuracySlider::chosen, this, choose);
        connect(input.box, &AccuracyBox::chosen, this, choose);
        auto* label = new QLabel(row.label);
        label->setBuddy(input.box);
        const int number = static_cast<int>(rangeInputs_.size());
        grid->addWidget(label, number, 0);
        grid->addWidget(input.slider, number, 1);
        grid->addWidget(input.box, number, 2);
        rangeInputs_.push_back(input);
    }
    return grid;
}

void RegionPanel::showModel()
{
    setEnabled(session_.model() != nullptr);
    if (const auto& model = session_.model()) {
        const ValueRange range = session_.range();
        const Eigen::AlignedBox3d& bounds = model->description().bounds;
        from_->setRange(bounds.min(), bounds.max());
        to_->setRange(bounds.min(), bounds.max());
        const ModelDescription& description = model->description();
        const QString ends =
            tr("In data units: %1 to %2")
                .arg(rangeEndText(range.minimum, description), rangeEndText(range.maximum, description));
        least_->setTexts(tr("Smallest value"), ends);
        largest_->setTexts(tr("Largest value"), ends);
        for (ValueSlider* slider : {least_, largest_}) {
            slider->box()->setOfLogarithms(logarithmsOf(description).has_value());
            slider->setRange(range.minimum, range.maximum);
            slider->box()->setFixedWidth(slider->box()->sizeHint().width());
        }
    }
    showQuery();
}

void RegionPanel::showQuery()
{
    const QueryState& query = session_.view().query;
    window_->setChecked(query.window.enabled);
    windowSettings_->setVisible(query.window.enabled);
    reset_->setVisible(query.window.enabled);
    from_->setValue(query.window.window.box.least);
    to_->setValue(query.window.window.box.largest);
    border_->setCurrentIndex(
        static_cast<int>(std::ranges::find(borders, query.window.window.border) - borders.begin()));
    values_->setChecked(query.values.enabled);
    valueSettings_->setVisible(query.values.enabled);
    least_->setValue(query.values.least);
    largest_->setValue(query.values.largest);
    range_->setChecked(query.range.enabled);
    rangeSettings_->setVisible(query.range.enabled);
    for (const RangeInput& input : rangeInputs_) {
        input.slider->setAccuracy(query.range.*input.percent);
        input.box->setAccuracy(query.range.*input.percent);
    }
}

} // namespace tetra
