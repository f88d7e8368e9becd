// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QMainWindow;
class QMenu;

namespace tetra {

class Session;

/// The menu of the session's bookmarks: one is added, all are edited in a BookmarkDialog, and each is shown by an
/// action named action.bookmark.1 and so on, the first nine by keys.
class BookmarkActions : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    BookmarkActions(Session& session, QMenu& menu, QMainWindow& window);

signals:
    void added(const QString& name);

private:
    void edit();
    void follow();

    Session& session_;
    QMenu& menu_;
    QMainWindow& window_;
    QAction* add_;
    QAction* edit_;
    QList<QAction*> bookmarks_;
};

} // namespace tetra
