// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/value_box.h"

#include "plugins/widgets/number_text.h"

namespace tetra {
namespace {

/// Between these extents plain decimals are readable.
bool isPlain(double extent)
{
    return extent >= 1e-4 && extent < 1e7;
}

/// QDoubleSpinBox rounds its value to its decimals; this many keep any double.
constexpr int allDecimals = 323;

} // namespace

ValueBox::ValueBox(QWidget* parent) : QDoubleSpinBox(parent)
{
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

void ValueBox::setValueRange(double minimum, double maximum)
{
    extent_ = maximum - minimum;
    setDecimals(isPlain(extent_) ? decimalsFor(extent_) : allDecimals);
    setRange(minimum, maximum);
    setSingleStep(extent_ / 100);
}

QString ValueBox::textFromValue(double value) const
{
    return isPlain(extent_) ? QDoubleSpinBox::textFromValue(value) : locale().toString(value, 'g', 6);
}

double ValueBox::valueFromText(const QString& text) const
{
    return locale().toDouble(QString(text).remove(suffix()).trimmed());
}

QValidator::State ValueBox::validate(QString& text, int& position) const
{
    Q_UNUSED(position);
    bool isNumber = false;
    const double value = locale().toDouble(QString(text).remove(suffix()).trimmed(), &isNumber);
    return isNumber && value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

} // namespace tetra
