// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace tetra {

/// A sentence that says whether something is as it should be: green with a tick, or red with a cross.
class CheckLabel : public QLabel {
    Q_OBJECT
public:
    explicit CheckLabel(const QString& name, QWidget* parent = nullptr);

    void showCheck(bool fits, const QString& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    void colour();

    bool fits_ = true;
};

} // namespace tetra
