// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/bookmark_dialog.h"

#include "ui/session/bookmarks.h"
#include "ui/session/message_text.h"
#include "ui/session/session.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace tetra {

BookmarkDialog::BookmarkDialog(Session& session, QWidget* parent)
    : QDialog(parent), session_(session), list_(new QListWidget)
{
    setObjectName("bookmarkDialog");
    setWindowTitle(tr("Bookmarks"));
    list_->setObjectName("bookmarks.list");
    list_->setAccessibleName(tr("Bookmarks"));
    list_->setToolTip(tr("Enter shows a bookmark, F2 renames it, Delete removes it, Alt with an arrow moves it"));
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setTabKeyNavigation(false);
    list_->installEventFilter(this);
    auto* buttons = new QVBoxLayout;
    addButton(*buttons, "add", tr("&Add"), tr("Add the current view as a bookmark"), &BookmarkDialog::add);
    ofBookmarks_ = {
        addButton(*buttons, "show", tr("&Show"), tr("Show this bookmark (Enter)"), &BookmarkDialog::showCurrent),
        addButton(*buttons, "replace", tr("Re&place"), tr("Replace this bookmark with the current view"),
                  &BookmarkDialog::replace),
        addButton(*buttons, "rename", tr("Re&name"), tr("Rename this bookmark (F2)"), &BookmarkDialog::rename),
        addButton(*buttons, "up", tr("Move &Up"), tr("Swap with the previous bookmark (Alt+Up)"), &BookmarkDialog::up),
        addButton(*buttons, "down", tr("Move &Down"), tr("Swap with the next bookmark (Alt+Down)"),
                  &BookmarkDialog::down),
        addButton(*buttons, "remove", tr("&Remove"), tr("Remove this bookmark (Delete)"), &BookmarkDialog::remove)};
    buttons->addStretch();
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* both = new QHBoxLayout;
    both->addWidget(list_, 1);
    both->addLayout(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(both);
    layout->addWidget(close);
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) { takeName(list_->row(item)); });
    connect(list_, &QListWidget::itemDoubleClicked, this, &BookmarkDialog::showCurrent);
    connect(list_, &QListWidget::currentRowChanged, this, &BookmarkDialog::enableButtons);
    session_.whenChanged(ViewPart::Bookmarks, this, &BookmarkDialog::fill);
    connect(&session_, &Session::modelChanged, this, &BookmarkDialog::fill);
    fill();
    list_->setFocus();
}

QPushButton* BookmarkDialog::addButton(QLayout& layout, const char* name, const QString& text, const QString& toolTip,
                                       void (BookmarkDialog::*clicked)())
{
    auto* button = new QPushButton(text);
    button->setObjectName(QString("bookmarks.") + name);
    button->setToolTip(toolTip);
    button->setAutoDefault(false); // Enter is for the list
    connect(button, &QPushButton::clicked, this, clicked);
    layout.addWidget(button);
    return button;
}

bool BookmarkDialog::eventFilter(QObject* watched, QEvent* event)
{
    const bool isOfEditor = list_->findChild<QLineEdit*>() != nullptr; // which hands on the keys that end it
    if (event->type() != QEvent::KeyPress || isOfEditor)
        return QDialog::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool alt = key.modifiers().testFlag(Qt::AltModifier);
    if (key.key() == Qt::Key_Delete)
        remove();
    else if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter)
        showCurrent();
    else if (alt && (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down))
        move(key.key() == Qt::Key_Up ? -1 : 1);
    else
        return QDialog::eventFilter(watched, event);
    return true;
}

void BookmarkDialog::fill()
{
    if (renaming_)
        return;
    const int selected = list_->currentRow();
    filling_ = true;
    list_->clear();
    for (const Bookmark& bookmark : session_.view().bookmarks) {
        auto* item = new QListWidgetItem(shownText(bookmark.name), list_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    filling_ = false;
    select(std::min(std::max(selected, 0), list_->count() - 1));
    enableButtons();
}

void BookmarkDialog::enableButtons()
{
    for (QPushButton* button : ofBookmarks_)
        button->setEnabled(list_->currentRow() >= 0);
}

void BookmarkDialog::select(int index)
{
    if (index >= 0)
        list_->setCurrentRow(index);
}

void BookmarkDialog::add()
{
    addBookmark(session_);
    select(list_->count() - 1);
}

void BookmarkDialog::showCurrent()
{
    showBookmark(session_, list_->currentRow());
}

void BookmarkDialog::replace()
{
    const auto& bookmarks = session_.view().bookmarks;
    if (list_->currentRow() >= 0)
        session_.setView(withBookmark(session_.view(), bookmarks[static_cast<std::size_t>(list_->currentRow())].name));
}

void BookmarkDialog::rename()
{
    if (QListWidgetItem* item = list_->currentItem())
        list_->editItem(item);
}

void BookmarkDialog::remove()
{
    ViewValue view = session_.view();
    if (list_->currentRow() < 0)
        return;
    view.bookmarks.erase(view.bookmarks.begin() + list_->currentRow());
    session_.setView(std::move(view));
}

void BookmarkDialog::move(int steps)
{
    const int from = list_->currentRow(), to = from + steps;
    if (from < 0 || to < 0 || to >= list_->count())
        return;
    ViewValue view = session_.view();
    std::swap(view.bookmarks[static_cast<std::size_t>(from)], view.bookmarks[static_cast<std::size_t>(to)]);
    session_.setView(std::move(view));
    select(to);
}

/// A name that is empty or another bookmark's changes nothing.
void BookmarkDialog::takeName(int row)
{
    if (filling_ || row < 0)
        return;
    ViewValue view = session_.view();
    Bookmark& bookmark = view.bookmarks[static_cast<std::size_t>(row)];
    const std::string name = list_->item(row)->text().trimmed().toStdString();
    if (list_->item(row)->text() != shownText(bookmark.name) && !name.empty() &&
        std::ranges::find(view.bookmarks, name, &Bookmark::name) == view.bookmarks.end())
        bookmark.name = name;
    renaming_ = true;
    session_.setView(std::move(view));
    renaming_ = false;
    // In its own time: the editor is still open.
    QMetaObject::invokeMethod(this, &BookmarkDialog::fill, Qt::QueuedConnection);
}

} // namespace tetra
