// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/palette_commands.h"

#include <QFrame>
#include <QString>

#include <optional>

class QLineEdit;
class QMainWindow;
class QTreeWidget;

namespace tetra {

/// How well what somebody types names `text`: each word of the query has to occur, its letters in order but not
/// necessarily side by side. More is better; nothing if it does not match. Case and accents do not matter. An empty
/// query matches everything equally. O(query * text).
std::optional<int> fuzzyMatch(const QString& query, const QString& text);

/// Finds whatever the program can do by a few letters of its name, and does it: keys alone are enough. Lies over the
/// window, and goes when it loses the keys. What cannot be done now is grey and says why.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    /// A child of the window.
    CommandPalette(QMainWindow& window, Session& session);

    /// Shows all commands, to be searched.
    void open();

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void search(const QString& query);
    void run();
    void leave();
    bool keyPress(QKeyEvent& event);

    QMainWindow& window_;
    Session& session_;
    QLineEdit* search_;
    QTreeWidget* list_;
    std::vector<PaletteCommand> commands_;
    QWidget* before_ = nullptr; ///< what had the keys
};

} // namespace tetra
