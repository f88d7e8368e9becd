// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tetra {

/// What is seen instead of a picture while there is none: what to do next, and the files opened last.
class EmptyPage : public QWidget {
    Q_OBJECT
public:
    explicit EmptyPage(QWidget* parent = nullptr);

    /// Nothing is open: invites to open something.
    void invite(const QStringList& recentFiles);
    /// Something is under way or next: `title` names it, `text` says what.
    void tell(const QString& title, const QString& text);

signals:
    void openClicked();
    void recentClicked(const QString& path);

private:
    void showRecent(const QStringList& files);

    QLabel* title_;
    QLabel* text_;
    QPushButton* open_;
    QLabel* recentTitle_;
    QVBoxLayout* recent_;
};

} // namespace tetra
