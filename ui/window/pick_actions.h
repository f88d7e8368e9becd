// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

class QMenu;

namespace tetra {

class ValuePick;
class Workbench;

/// The actions of the menu of the picked value: to pick one by a key, to make an isovalue or a point of the transfer
/// function of it (of several the one that is chosen in the editor), and to take its mark away.
class PickActions : public QObject {
    Q_OBJECT
public:
    /// Workbench and pick outlive the menu.
    PickActions(Workbench& workbench, ValuePick& pick, QMenu& menu);

private:
    void addPoint();
    void follow();

    Workbench& workbench_;
    ValuePick& pick_;
    QAction* pickValue_;
    QAction* isovalue_;
    QAction* point_;
    QAction* forget_;
};

} // namespace tetra
