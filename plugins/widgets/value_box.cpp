// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/value_box.h"

#include "plugins/widgets/number_text.h"

#include <QLineEdit>
#include <QStyleOptionSpinBox>

#include <cmath>

namespace tetra {
namespace {

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

/// Between these extents plain decimals are readable.
bool ValueBox::isPlain() const
{
    return !ofLogarithms_ && extent_ >= 1e-4 && extent_ < 1e7;
}

/// What was typed, as the box counts.
double ValueBox::number(const QString& text, bool& isNumber) const
{
    QString written = QString(text).remove(suffix()).trimmed();
    if (meanAndDeviation_)
        for (const QString& unit : {QStringLiteral("sd"), QStringLiteral("σ")})
            if (written.endsWith(unit)) {
                written.chop(unit.size());
                return meanAndDeviation_->first +
                       meanAndDeviation_->second * locale().toDouble(written.trimmed(), &isNumber);
            }
    const double typed = locale().toDouble(written, &isNumber);
    if (!ofLogarithms_ || !isNumber)
        return typed;
    isNumber = typed > 0;
    return isNumber ? std::log10(typed) : 0;
}

QSize ValueBox::minimumSizeHint() const
{
    ensurePolished();
    // Room for the usual six digits, so that nothing moves while a value changes.
    const QString usual = prefix() + locale().toString(0.0, 'f', 6) + suffix();
    const QString shortest =
        isPlain() ? text()
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
    setDecimals(isPlain() ? decimalsFor(extent_) : allDecimals);
    setRange(minimum, maximum);
    setSingleStep(extent_ / 100);
}

QString ValueBox::textFromValue(double value) const
{
    if (isPlain())
        return QDoubleSpinBox::textFromValue(value);
    return locale().toString(ofLogarithms_ ? std::pow(10.0, value) : value, 'g', 6);
}

double ValueBox::valueFromText(const QString& text) const
{
    // What is shown has lost digits: nobody who leaves it as it is means another value.
    if (ofLogarithms_ && QString(text).remove(suffix()).trimmed() == textFromValue(value()))
        return value();
    bool isNumber = false;
    return number(text, isNumber);
}

QValidator::State ValueBox::validate(QString& text, int& position) const
{
    Q_UNUSED(position);
    bool isNumber = false;
    const double value = number(text, isNumber);
    const double room = ofLogarithms_ ? 1e-5 : 0; // the ends are shown rounded
    return isNumber && value >= minimum() - room && value <= maximum() + room ? QValidator::Acceptable
                                                                              : QValidator::Intermediate;
}

} // namespace tetra
