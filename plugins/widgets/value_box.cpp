// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/value_box.h"

#include "plugins/widgets/number_text.h"

#include <QLineEdit>
#include <QStyleOptionSpinBox>

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
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // down to minimumSizeHint()
    connect(lineEdit(), &QLineEdit::textChanged, this, [this] { updateGeometry(); });
}

QSize ValueBox::minimumSizeHint() const
{
    ensurePolished();
    // Room for the usual six digits, so that nothing moves while a value changes.
    const QString usual = prefix() + locale().toString(0.0, 'f', 6) + suffix();
    const QString shortest =
        isPlain(extent_)
            ? text()
            : std::max(usual, text(), [](const QString& a, const QString& b) { return a.size() < b.size(); });
    constexpr int lineMargins = 6; // of QLineEdit beside its text, and the cursor
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const QSize content(fontMetrics().horizontalAdvance(shortest) + lineMargins,
                        lineEdit()->minimumSizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
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
