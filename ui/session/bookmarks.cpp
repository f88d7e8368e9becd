// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/bookmarks.h"

#include "ui/session/session.h"

#include <QCoreApplication>

#include <algorithm>

namespace tetra {
namespace {

class BookmarkTexts {
    Q_DECLARE_TR_FUNCTIONS(Bookmarks)
};

} // namespace

QString addBookmark(Session& session)
{
    const auto& bookmarks = session.view().bookmarks;
    if (!session.model() || bookmarks.size() >= mostBookmarks)
        return {};
    std::size_t number = bookmarks.size() + 1;
    const auto name = [&number] { return BookmarkTexts::tr("View %1").arg(number); };
    while (std::ranges::find(bookmarks, name().toStdString(), &Bookmark::name) != bookmarks.end())
        ++number;
    session.setView(withBookmark(session.view(), name().toStdString()), BookmarkTexts::tr("Add Bookmark"));
    return name();
}

void showBookmark(Session& session, int index)
{
    const auto& bookmarks = session.view().bookmarks;
    if (index >= 0 && static_cast<std::size_t>(index) < bookmarks.size())
        session.setView(atBookmark(session.view(), bookmarks[static_cast<std::size_t>(index)]),
                        BookmarkTexts::tr("Show Bookmark"));
}

} // namespace tetra
