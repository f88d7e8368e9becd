// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <vector>

class QListWidget;
class QPushButton;

namespace tetra {

class Session;

/// The session's bookmarks: what is seen is added to them or takes the place of one; they are shown, renamed, put into
/// another order and removed, each as one step to undo. Stands beside the window, which works on. By keyboard: Enter
/// shows one, F2 renames it, Delete removes it, Alt with an arrow moves it. Named bookmarkDialog, with bookmarks.list,
/// .add, .show, .replace, .rename, .up, .down and .remove.
class BookmarkDialog : public QDialog {
    Q_OBJECT
public:
    /// `session` outlives it.
    BookmarkDialog(Session& session, QWidget* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QPushButton* addButton(QLayout& layout, const char* name, const QString& text, const QString& toolTip,
                           void (BookmarkDialog::*clicked)());
    void fill();
    void enableButtons();
    void select(int index);
    void add();
    void showCurrent();
    void replace();
    void rename();
    void remove();
    void up() { move(-1); }
    void down() { move(1); }
    void move(int steps);
    void takeName(int row);

    Session& session_;
    QListWidget* list_;
    std::vector<QPushButton*> ofBookmarks_; ///< that need one to be selected
    bool filling_ = false;
    bool renaming_ = false; ///< the item's editor is open
};

} // namespace tetra
