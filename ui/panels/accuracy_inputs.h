// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QSpinBox>

#include <cstdint>

namespace tetra {

/// A slider along the scale of accuracy_scale.h; keys and the wheel go to round numbers.
class AccuracySlider : public QSlider {
    Q_OBJECT
public:
    explicit AccuracySlider(QWidget* parent = nullptr);
    /// Shows it; tells nobody.
    void setAccuracy(double percent);
    /// How far the handle's centre at the ends lies inside the widget.
    int handleInset() const;

signals:
    /// By the user, in %.
    void chosen(double percent);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    double accuracy_ = 1;
};

/// A number box for an error in %, which steps through round numbers. Takes and keeps any number, plain or with an
/// exponent, and shows its first digits.
class AccuracyBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit AccuracyBox(QWidget* parent = nullptr);
    /// Shows it; tells nobody.
    void setAccuracy(double percent);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void stepBy(int steps) override;

signals:
    /// By the user, in %.
    void chosen(double percent);

protected:
    StepEnabled stepEnabled() const override;
};

/// A number box for a budget of tetrahedra, which steps through round numbers.
class BudgetBox : public QSpinBox {
    Q_OBJECT
public:
    explicit BudgetBox(QWidget* parent = nullptr);
    /// Shows it; tells nobody.
    void setBudget(std::uint64_t tetrahedra);
    void stepBy(int steps) override;

signals:
    /// By the user, in tetrahedra.
    void chosen(quint64 tetrahedra);

protected:
    StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }
};

} // namespace tetra
