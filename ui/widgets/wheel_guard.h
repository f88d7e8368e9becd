// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace tetra {

/// Who turns the wheel over a panel wants to scroll it, not to change what happens to come by below the pointer. So a
/// control gets the wheel only once it has the keys, by a click say, and never takes the keys because of the wheel;
/// else the area around it scrolls. True of every control in every window of the program, those of plugins and of Qt's
/// own dialogs as well; what only scrolls is let alone.
class WheelGuard : public QObject {
    Q_OBJECT
public:
    /// From now on. `picture` always has the wheel: there it zooms.
    explicit WheelGuard(const QWidget& picture, QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isKeptFromWheel(const QWidget& widget) const;

    const QWidget& picture_;
};

} // namespace tetra
