// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include <optional>
#include <utility>

namespace tetra {

/// A number box for values of any magnitude: plain decimals where they are readable, else scientific notation, both in
/// the user's locale. Takes either as input.
class ValueBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit ValueBox(QWidget* parent = nullptr);
    /// Steps and decimals follow the extent of the range.
    void setValueRange(double minimum, double maximum);
    /// Whether its value, the range and the steps are logarithms to base 10, which are shown and typed as what they are
    /// of. Before setValueRange().
    void setOfLogarithms(bool ofLogarithms) { ofLogarithms_ = ofLogarithms; }
    /// Mean and standard deviation of the values, if they are known: then "2.5sd" and "2.5σ" can be typed, too, for the
    /// value that lies so many deviations above the mean. As the box counts.
    void setDeviations(const std::optional<std::pair<double, double>>& meanAndDeviation)
    {
        meanAndDeviation_ = meanAndDeviation;
    }

    /// As wide as its value is written, in the letters of the user: it may be narrow, but never cuts a digit.
    QSize minimumSizeHint() const override;
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

private:
    bool isPlain() const;
    double number(const QString& text, bool& isNumber) const;

    double extent_ = 100;
    bool ofLogarithms_ = false;
    std::optional<std::pair<double, double>> meanAndDeviation_{};
};

} // namespace tetra
