// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class QTableWidget;
class QToolButton;

namespace tetra {

class Session;

/// The key frames of the session's film: times to edit, and what each shows. By keyboard: Delete removes one, Alt with
/// an arrow moves it, Enter shows it. Named animation.keys, with .add, .update, .show, .remove, .up and .down.
class KeyFrameList : public QWidget {
    Q_OBJECT
public:
    explicit KeyFrameList(Session& session, QWidget* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QToolButton* addButton(const char* name, const QString& text, const QString& toolTip,
                           void (KeyFrameList::*clicked)());
    void fill();
    void enableButtons();
    int current() const;
    void select(int index);
    void addPresent();
    void replaceByPresent();
    void showKey();
    void remove();
    void up() { move(-1); }
    void down() { move(1); }
    void move(int steps);
    void setTime(int row);

    Session& session_;
    QTableWidget* table_;
    std::vector<QToolButton*> ofKeys_; ///< that need one to be selected
    bool filling_ = false;
};

} // namespace tetra
