// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/command_palette.h"

#include "ui/widgets/word_match.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QStringList>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>
#include <vector>

namespace tetra {
namespace {

constexpr QSize largest(840, 420); ///< room for the longest command beside what it needs, in every language
constexpr int fromEdge = 48;       ///< of the window
constexpr int indexRole = Qt::UserRole;

} // namespace

CommandPalette::CommandPalette(QMainWindow& window, Workbench& workbench)
    : QFrame(&window), window_(window), workbench_(workbench), search_(new QLineEdit), list_(new QTreeWidget)
{
    setObjectName("palette");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    search_->setObjectName("palette.search");
    search_->setPlaceholderText(tr("Type what you want to do"));
    search_->setAccessibleName(tr("Command"));
    search_->setToolTip(
        tr("Type the beginnings of words to find a command or a setting. Enter runs it, Esc closes the list."));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    list_->setObjectName("palette.list");
    list_->setAccessibleName(tr("Commands"));
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setFocusPolicy(Qt::NoFocus); // the keys stay with the text
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(list_);
    connect(search_, &QLineEdit::textChanged, this, &CommandPalette::search);
    connect(list_, &QTreeWidget::itemClicked, this, &CommandPalette::run);
    hide();
}

void CommandPalette::open()
{
    before_ = QApplication::focusWidget();
    commands_ = paletteCommands(window_, workbench_);
    const QSize room = window_.size() - QSize(2 * fromEdge, 2 * fromEdge);
    resize(largest.boundedTo(room));
    move((window_.width() - width()) / 2, fromEdge);
    search_->clear();
    search({});
    show();
    raise();
    search_->setFocus();
}

void CommandPalette::search(const QString& typed)
{
    const QString query = typed.trimmed();
    // Of what is equally good the shortest comes first: nothing of it is left over. Else the order stays. Settings are
    // for those who look for one: they would hide the commands.
    std::vector<std::tuple<int, qsizetype, std::size_t>> found;
    const auto lengthOf = [&query](const QString& text) { return query.isEmpty() ? 0 : text.size(); };
    for (std::size_t index = 0; index < commands_.size(); ++index) {
        const PaletteCommand& command = commands_[index];
        auto match = wordMatch(query, command.text, command.ownStart);
        if (!match && wordMatch(query, command.spoken))
            match = 0; // what is read comes first
        if (match && !(query.isEmpty() && command.isSetting))
            found.emplace_back(-*match, lengthOf(command.text), index);
    }
    std::ranges::sort(found);
    list_->clear();
    for (const auto& [match, length, index] : found)
        addItem(index, match == std::get<0>(found.front()));
    if (found.empty())
        listExplained(query);
}

/// What explains itself by the words typed is listed where no name has them, to be chosen: Enter alone does none of it.
void CommandPalette::listExplained(const QString& query)
{
    for (std::size_t index = 0; index < commands_.size(); ++index)
        if (const PaletteCommand& command = commands_[index];
            wordMatch(query, command.text + ' ' + command.explanation))
            addItem(index, false);
    if (list_->topLevelItemCount() == 0)
        (new QTreeWidgetItem(list_, {tr("Nothing found")}))->setDisabled(true);
}

/// Enter does the first of the best ones that can be done. What fits less well is there to be chosen, not to be done
/// by somebody who has typed what cannot be done now.
void CommandPalette::addItem(std::size_t index, bool isBest)
{
    const PaletteCommand& command = commands_[index];
    auto* item = new QTreeWidgetItem(list_, {command.text, command.reason.isEmpty() ? command.keys : command.reason});
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setData(0, indexRole, static_cast<qulonglong>(index));
    item->setToolTip(0, command.text);
    item->setDisabled(!command.reason.isEmpty());
    if (isBest && list_->currentItem() == nullptr && !item->isDisabled())
        list_->setCurrentItem(item);
}

void CommandPalette::run()
{
    const QTreeWidgetItem* item = list_->currentItem();
    if (item == nullptr || item->isDisabled())
        return;
    const std::function<void()> chosen = commands_[item->data(0, indexRole).toULongLong()].run;
    leave();
    chosen();
}

/// Whoever had the keys gets them back.
void CommandPalette::leave()
{
    hide();
    if (before_)
        before_->setFocus();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && keyPress(*static_cast<QKeyEvent*>(event)))
        return true;
    if (event->type() == QEvent::FocusOut && isVisible() &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason)
        hide();
    return QFrame::eventFilter(watched, event);
}

bool CommandPalette::keyPress(QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Escape: leave(); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: run(); return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown: QCoreApplication::sendEvent(list_, &event); return true;
    default: return false;
    }
}

} // namespace tetra
