// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/region_panel.h"

#include "plugins/widgets/scrolled_column.h"
#include "plugins/widgets/value_box.h"
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
    : QWidget(parent), session_(session), window_(new QCheckBox(tr("Only a &window"))), windowSettings_(new QWidget),
      border_(new QComboBox), values_(new QCheckBox(tr("&Limit to a range of values"))), valueSettings_(new QWidget),
      least_(new ValueSlider("region.least", session)), largest_(new ValueSlider("region.largest", session)),
      reset_(new QPushButton(tr("&Reset to Whole Domain")))
{
    setObjectName("region");
    window_->setObjectName("region.window");
    window_->setToolTip(tr("Show only the part of the domain in a box (W)"));
    values_->setObjectName("region.values");
    values_->setToolTip(tr("Show only tetrahedra that can contain a value of a range. Isosurfaces of other values are "
                           "not seen, or only in part."));
    windowSettings_->setLayout(makeWindow());
    valueSettings_->setLayout(makeValues());

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
    layout->addStretch();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(content));

    connect(window_, &QCheckBox::clicked, this,
            [this](bool on) { editWindow([on](WindowState& window) { window.enabled = on; }); });
    connect(values_, &QCheckBox::clicked, this,
            [this](bool on) { editValues([on](ValueFilter& values) { values.enabled = on; }); });
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

QLayout* RegionPanel::makeWindow()
{
    auto* grid = new QGridLayout;
    grid->setContentsMargins({});
    addAxisNames(*grid, 0);
    const QString toolTip = tr("Bounds of the window, in data coordinates");
    from_ = new VectorInput("region.from", tr("Fro&m"), toolTip, session_, *grid, 1, this);
    to_ = new VectorInput("region.to", tr("&To"), toolTip, session_, *grid, 2, this);
    border_->setObjectName("region.border");
    border_->addItems({tr("Cut exactly"), tr("Keep tetrahedra that touch it"), tr("Keep tetrahedra inside")});
    border_->setAccessibleName(tr("Tetrahedra at the border"));
    border_->setToolTip(
        tr("How the window ends: tetrahedra at its border are cut exactly there, or kept or left out as a whole"));
    border_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto* label = new QLabel(tr("&Border"));
    label->setBuddy(border_);
    grid->addWidget(label, 3, 0);
    grid->addWidget(border_, 3, 1, 1, 3);
    reset_->setObjectName("region.reset");
    reset_->setToolTip(tr("Make the window as large as the domain"));

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

void RegionPanel::showModel()
{
    setEnabled(session_.model() != nullptr);
    if (const auto& model = session_.model()) {
        const ValueRange range = session_.range();
        const Eigen::AlignedBox3d& bounds = model->description().bounds;
        from_->setRange(bounds.min(), bounds.max());
        to_->setRange(bounds.min(), bounds.max());
        const QString ends =
            tr("In the units of the data: %1 to %2")
                .arg(QLocale().toString(range.minimum, 'g', 6), QLocale().toString(range.maximum, 'g', 6));
        least_->setTexts(tr("Smallest value"), ends);
        largest_->setTexts(tr("Largest value"), ends);
        for (ValueSlider* slider : {least_, largest_}) {
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
}

} // namespace tetra
