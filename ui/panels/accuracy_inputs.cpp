// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/accuracy_inputs.h"

#include "core/view/accuracy_scale.h"
#include "ui/session/accuracy_keys.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr int accuracySteps = 1000;

/// QDoubleSpinBox rounds its value to its decimals; this many keep any double.
constexpr int allDecimals = 323;

} // namespace

AccuracySlider::AccuracySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent)
{
    setObjectName("accuracy.slider");
    setRange(0, accuracySteps);
    setAccessibleName(tr("Error in percent of the value range"));
    setToolTip(tr("Error in percent of the value range: coarse on the left, every sample exact on the right"));
    connect(this, &QSlider::valueChanged, this,
            [this](int position) { emit chosen(accuracyAt(static_cast<double>(position) / accuracySteps)); });
}

void AccuracySlider::setAccuracy(double percent)
{
    accuracy_ = percent;
    const QSignalBlocker blocker(this);
    setValue(static_cast<int>(std::lround(accuracyPosition(percent) * accuracySteps)));
}

int AccuracySlider::handleInset() const
{
    return style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this) / 2;
}

void AccuracySlider::keyPressEvent(QKeyEvent* event)
{
    if (const auto percent = accuracyByKey(accuracy_, event->key()))
        emit chosen(*percent);
    else
        QSlider::keyPressEvent(event);
}

void AccuracySlider::wheelEvent(QWheelEvent* event)
{
    if (const int steps = event->angleDelta().y() / 120; steps != 0)
        emit chosen(steppedAccuracy(accuracy_, steps));
    event->accept();
}

AccuracyBox::AccuracyBox(QWidget* parent) : QDoubleSpinBox(parent)
{
    setObjectName("accuracy.box");
    setDecimals(allDecimals);
    setRange(0, 100);
    setSuffix(tr(" %"));
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(false);
    setAccessibleName(tr("Error in percent of the value range"));
    setToolTip(tr("Error in percent of the value range"));
    connect(this, &QDoubleSpinBox::valueChanged, this, &AccuracyBox::chosen);
}

void AccuracyBox::setAccuracy(double percent)
{
    const QSignalBlocker blocker(this);
    setValue(percent);
}

QString AccuracyBox::textFromValue(double value) const
{
    return locale().toString(value, 'g', 4);
}

double AccuracyBox::valueFromText(const QString& text) const
{
    return locale().toDouble(QString(text).remove(suffix()).trimmed());
}

QValidator::State AccuracyBox::validate(QString& text, int& position) const
{
    Q_UNUSED(position);
    bool isNumber = false;
    const double value = locale().toDouble(QString(text).remove(suffix()).trimmed(), &isNumber);
    return isNumber && value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

void AccuracyBox::stepBy(int steps)
{
    setValue(steppedAccuracy(value(), -steps));
}

AccuracyBox::StepEnabled AccuracyBox::stepEnabled() const
{
    StepEnabled steps;
    steps.setFlag(StepUpEnabled, value() < coarsestOnScale);
    steps.setFlag(StepDownEnabled, value() > 0);
    return steps;
}

BudgetBox::BudgetBox(QWidget* parent) : QSpinBox(parent)
{
    setObjectName("accuracy.budget");
    setRange(1, std::numeric_limits<int>::max());
    setGroupSeparatorShown(true);
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(false);
    setAccessibleName(tr("Most tetrahedra"));
    setToolTip(tr("The best mesh with at most this number of tetrahedra"));
    connect(this, &QSpinBox::valueChanged, this, [this](int count) { emit chosen(static_cast<quint64>(count)); });
    // Also the number that stood there already, if somebody says that it is to hold.
    connect(lineEdit(), &QLineEdit::returnPressed, this, [this] { emit chosen(static_cast<quint64>(value())); });
}

void BudgetBox::setBudget(std::uint64_t tetrahedra)
{
    const QSignalBlocker blocker(this);
    setValue(static_cast<int>(std::min<std::uint64_t>(tetrahedra, std::numeric_limits<int>::max())));
}

void BudgetBox::stepBy(int steps)
{
    const std::uint64_t next = steppedBudget(static_cast<std::uint64_t>(value()), steps);
    setValue(static_cast<int>(std::min<std::uint64_t>(next, std::numeric_limits<int>::max())));
}

} // namespace tetra
