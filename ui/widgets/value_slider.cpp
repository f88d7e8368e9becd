// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/value_slider.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/value_box.h"
#include "ui/session/session.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace tetra {
namespace {

constexpr int sliderSteps = 1000;

} // namespace

ValueSlider::ValueSlider(const QString& name, Session& session, QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal)), box_(new ValueBox)
{
    rename(name);
    slider_->setRange(0, sliderSteps);
    slider_->setSingleStep(sliderSteps / 100);
    slider_->setPageStep(sliderSteps / 10);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(slider_, 1);
    layout->addWidget(box_);
    setFocusProxy(slider_);
    new GestureWatcher(slider_, session);
    new GestureWatcher(box_, session);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int position) { emit edited(minimum_ + (maximum_ - minimum_) * position / sliderSteps); });
    connect(box_, &QDoubleSpinBox::valueChanged, this, &ValueSlider::edited);
}

void ValueSlider::rename(const QString& name)
{
    setObjectName(name);
    slider_->setObjectName(name + ".slider");
    box_->setObjectName(name + ".box");
}

void ValueSlider::setRange(double minimum, double maximum)
{
    minimum_ = minimum;
    maximum_ = maximum;
    const QSignalBlocker blocker(box_);
    box_->setValueRange(minimum, maximum);
    showOnSlider();
}

void ValueSlider::setValue(double value)
{
    value_ = value;
    const QSignalBlocker blocker(box_);
    box_->setValue(value);
    showOnSlider();
}

void ValueSlider::setTexts(const QString& accessibleName, const QString& toolTip)
{
    slider_->setAccessibleName(accessibleName);
    box_->setAccessibleName(accessibleName);
    setToolTip(toolTip);
}

void ValueSlider::showOnSlider()
{
    const QSignalBlocker blocker(slider_);
    const double extent = maximum_ - minimum_;
    slider_->setValue(extent > 0 ? static_cast<int>(std::lround((value_ - minimum_) / extent * sliderSteps)) : 0);
}

} // namespace tetra
