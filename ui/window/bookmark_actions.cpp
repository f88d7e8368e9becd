// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/bookmark_actions.h"

#include "ui/dialogs/bookmark_dialog.h"
#include "ui/session/bookmarks.h"
#include "ui/session/message_text.h"
#include "ui/session/session.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/actions.h"
#include "ui/window/palette_commands.h"

#include <QMainWindow>
#include <QMenu>

namespace tetra {

BookmarkActions::BookmarkActions(Session& session, QMenu& menu, QMainWindow& window)
    : QObject(&menu), session_(session), menu_(menu), window_(window)
{
    add_ = addAction(menu, "bookmark.add", tr("&Add Bookmark"), QKeySequence("Ctrl+B"),
                     tr("Keep the current view as a bookmark, which the session saves"));
    edit_ = addAction(menu, "bookmark.edit", tr("&Edit Bookmarks…"), QKeySequence("Ctrl+Shift+B"),
                      tr("Show, rename, replace, move and remove bookmarks"));
    menu.addSeparator();
    for (QAction* action : {add_, edit_})
        setNeed(*action, tr("Open a model first"));
    connect(add_, &QAction::triggered, this, [this] {
        if (const QString name = addBookmark(session_); !name.isEmpty())
            emit added(name);
    });
    connect(edit_, &QAction::triggered, this, &BookmarkActions::edit);
    connect(&session_, &Session::modelChanged, this, &BookmarkActions::follow);
    session_.whenChanged(ViewPart::Bookmarks, this, &BookmarkActions::follow);
    follow();
}

void BookmarkActions::edit()
{
    auto* dialog = window_.findChild<BookmarkDialog*>();
    if (dialog == nullptr) {
        dialog = new BookmarkDialog(session_, &window_);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void BookmarkActions::follow()
{
    constexpr int withKeys = 9;
    const bool isOpen = session_.model() != nullptr;
    const auto& bookmarks = session_.view().bookmarks;
    add_->setEnabled(isOpen && bookmarks.size() < mostBookmarks);
    edit_->setEnabled(isOpen);
    qDeleteAll(bookmarks_);
    bookmarks_.clear();
    for (int index = 0; index < std::ssize(bookmarks); ++index) {
        const QString name = shownText(bookmarks[static_cast<std::size_t>(index)].name).replace('&', "&&");
        const QByteArray id = "bookmark." + QByteArray::number(index + 1);
        QAction* action =
            addAction(menu_, id.constData(), name,
                      index < withKeys ? QKeySequence(QString("Ctrl+Shift+%1").arg(index + 1)) : QKeySequence(),
                      tr("Show this bookmark"));
        connect(action, &QAction::triggered, this, [this, index] { showBookmark(session_, index); });
        bookmarks_.append(action);
    }
    giveMnemonics(menu_);
}

} // namespace tetra
