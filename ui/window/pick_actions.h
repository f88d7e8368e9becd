// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

class QMenu;

namespace tetra {

class Session;
class ValuePick;

/// The actions of the menu of the picked value: to pick one by a key, to make an isovalue or a point of the transfer
/// function of it, and to take its mark away.
class PickActions : public QObject {
    Q_OBJECT
public:
    /// Session and pick outlive the menu.
    PickActions(Session& session, ValuePick& pick, QMenu& menu);

private:
    void addPoint();
    void follow();

    Session& session_;
    ValuePick& pick_;
    QAction* pickValue_;
    QAction* isovalue_;
    QAction* point_;
    QAction* forget_;
};

} // namespace tetra
