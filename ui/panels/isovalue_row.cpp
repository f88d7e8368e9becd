// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/isovalue_row.h"

#include "plugins/widgets/colour_button.h"
#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/icons.h"
#include "plugins/widgets/value_box.h"
#include "ui/session/logarithm_text.h"
#include "ui/widgets/value_slider.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace tetra {

IsovalueRow::IsovalueRow(Session& session, int index, QWidget* parent)
    : QWidget(parent), session_(session), index_(index), visible_(new QCheckBox), colour_(new ColourButton),
      value_(new ValueSlider("value", session)), opacity_(new ValueSlider("opacity", session)), remove_(new QToolButton)
{
    const ValueRange range = session.range();
    const ModelDescription description = session.model() ? session.model()->description() : ModelDescription();
    statistics_ = keptStatistics(description.parameters);
    value_->box()->setOfLogarithms(logarithmsOf(description).has_value());
    if (statistics_)
        value_->box()->setDeviations(std::pair(statistics_->mean, statistics_->deviation));
    value_->setRange(range.minimum, range.maximum);
    value_->setTexts(tr("Isovalue"),
                     tr("Isovalue, in the units of the data: %1 to %2")
                         .arg(rangeEndText(range.minimum, description), rangeEndText(range.maximum, description)));
    opacity_->setRange(1, 100);
    opacity_->box()->setDecimals(0);
    opacity_->box()->setSuffix(tr(" %"));
    opacity_->setTexts(tr("Opacity"), tr("Opacity in percent; below 100 % what lies behind it shows through"));
    visible_->setToolTip(tr("Show this isosurface"));
    visible_->setAccessibleName(tr("Show this isosurface"));
    remove_->setIcon(glyphIcon(Glyph::Remove));
    remove_->setAutoRaise(true);
    remove_->setToolTip(tr("Remove this isovalue (Del)"));
    remove_->setAccessibleName(tr("Remove this isovalue"));
    layOut();
    const QString name = QString("isovalue.%1").arg(index);
    setObjectName(name);
    visible_->setObjectName(name + ".visible");
    colour_->setObjectName(name + ".colour");
    remove_->setObjectName(name + ".remove");
    value_->rename(name + ".value");
    opacity_->rename(name + ".opacity");
    if (deviations_ != nullptr)
        deviations_->setObjectName(name + ".deviations");
    refresh();
    connectControls();
}

void IsovalueRow::layOut()
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 4, 0, 4);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(2, 1);
    grid->addWidget(visible_, 0, 0);
    grid->addWidget(colour_, 0, 1);
    grid->addWidget(value_, 0, 2);
    grid->addWidget(remove_, 0, 3);
    if (statistics_)
        addDeviations(*grid);
    const int row = grid->rowCount();
    grid->addWidget(new QLabel(tr("Opacity")), row, 0, 1, 2);
    grid->addWidget(opacity_, row, 2);
    // Both number boxes as wide as the wider one, so that the sliders above each other end at one line.
    const int width = std::max(value_->box()->sizeHint().width(), opacity_->box()->sizeHint().width());
    value_->box()->setFixedWidth(width);
    opacity_->box()->setFixedWidth(width);
}

/// The same value once more, as people of density maps tell it.
void IsovalueRow::addDeviations(QGridLayout& grid)
{
    const ValueRange range = session_.range();
    deviations_ = new ValueBox;
    deviations_->setSuffix(tr(" sd"));
    deviations_->setValueRange(statistics_->deviationsAt(range.minimum), statistics_->deviationsAt(range.maximum));
    deviations_->setAccessibleName(tr("Isovalue in standard deviations above the mean"));
    deviations_->setToolTip(
        tr("The isovalue in standard deviations above the mean. The mean of all samples is %1, their "
           "standard deviation %2. In the box above, 2.5sd can be typed, too.")
            .arg(locale().toString(statistics_->mean, 'g', 6), locale().toString(statistics_->deviation, 'g', 6)));
    new GestureWatcher(deviations_, session_);
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(tr("Above the mean")), row, 0, 1, 2);
    grid.addWidget(deviations_, row, 2, Qt::AlignRight);
    connect(deviations_, &QDoubleSpinBox::valueChanged, this, [this](double deviations) {
        edit([value = statistics_->valueAt(deviations)](Isovalue& isovalue) { isovalue.value = value; });
    });
}

void IsovalueRow::connectControls()
{
    connect(visible_, &QCheckBox::clicked, this,
            [this](bool on) { edit([on](Isovalue& isovalue) { isovalue.visible = on; }); });
    connect(colour_, &ColourButton::colourChosen, this, [this](const QColor& colour) {
        edit([&colour](Isovalue& isovalue) {
            isovalue.red = colour.redF();
            isovalue.green = colour.greenF();
            isovalue.blue = colour.blueF();
        });
    });
    connect(value_, &ValueSlider::edited, this,
            [this](double value) { edit([value](Isovalue& isovalue) { isovalue.value = value; }); });
    connect(opacity_, &ValueSlider::edited, this, [this](double percent) {
        edit([percent](Isovalue& isovalue) { isovalue.opacity = static_cast<float>(percent / 100); });
    });
    connect(remove_, &QToolButton::clicked, this, [this] { session_.removeIsovalue(index_); });
}

void IsovalueRow::refresh()
{
    visible_->setChecked(isovalue().visible);
    colour_->setColour(qtColour({isovalue().red, isovalue().green, isovalue().blue}));
    value_->setValue(isovalue().value);
    if (deviations_ != nullptr) {
        const QSignalBlocker blocker(deviations_);
        deviations_->setValue(statistics_->deviationsAt(isovalue().value));
    }
    opacity_->setValue(isovalue().opacity * 100.0);
}

void IsovalueRow::focusValue()
{
    value_->box()->setFocus();
    value_->box()->selectAll();
}

void IsovalueRow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete)
        session_.removeIsovalue(index_);
    else
        QWidget::keyPressEvent(event);
}

const Isovalue& IsovalueRow::isovalue() const
{
    return session_.view().isovalues[static_cast<std::size_t>(index_)];
}

void IsovalueRow::edit(const std::function<void(Isovalue&)>& change)
{
    Isovalue changed = isovalue();
    change(changed);
    session_.setIsovalue(index_, changed);
    refresh(); // also when the session did not take it as it is
}

} // namespace tetra
