// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QSlider;

namespace tetra {

class Session;
class ValueBox;

/// A slider and a number box for one value of a range. Its parts are named NAME.slider and NAME.box.
class ValueSlider : public QWidget {
    Q_OBJECT
public:
    /// Drags and held keys become one step each of the session's undo stack.
    ValueSlider(const QString& name, Session& session, QWidget* parent = nullptr);

    void rename(const QString& name);
    void setRange(double minimum, double maximum);
    /// Shows `value`; tells nobody.
    void setValue(double value);
    double value() const noexcept { return value_; }
    ValueBox* box() const noexcept { return box_; }
    QSlider* slider() const noexcept { return slider_; }
    /// For people who hear what they do not see.
    void setTexts(const QString& accessibleName, const QString& toolTip);

signals:
    /// By the user.
    void edited(double value);

private:
    void showOnSlider();

    double minimum_ = 0;
    double maximum_ = 1;
    double value_ = 0;
    QSlider* slider_;
    ValueBox* box_;
};

} // namespace tetra
