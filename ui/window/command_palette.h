// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/palette_commands.h"

#include <QFrame>
#include <QPointer>
#include <QString>

#include <vector>

class QLineEdit;
class QMainWindow;
class QTreeWidget;

namespace tetra {

/// Finds whatever the program can do, and the settings in its panels, by the beginnings of their words, and does it or
/// goes there: keys alone are enough. Lies over the window, and goes when it loses the keys. What cannot be done now is
/// grey and says why.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    /// A child of the window.
    CommandPalette(QMainWindow& window, Workbench& workbench);

    /// Shows all commands, to be searched.
    void open();

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void search(const QString& query);
    void listExplained(const QString& query);
    void addItem(std::size_t index, bool isBest);
    void run();
    void leave();
    bool keyPress(QKeyEvent& event);

    QMainWindow& window_;
    Workbench& workbench_;
    QLineEdit* search_;
    QTreeWidget* list_;
    std::vector<PaletteCommand> commands_;
    QPointer<QWidget> before_; ///< what had the keys; a form may have made its rows anew meanwhile
};

} // namespace tetra
