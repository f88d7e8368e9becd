// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/command_palette.h"

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

constexpr int forLetter = 1;
constexpr int forNeighbour = 4;  ///< a letter right after the one before
constexpr int forWordStart = 6;  ///< a letter that begins a word of the text
constexpr int forBeginning = 20; ///< a word of the text begins with that of the query
constexpr int none = -1;

/// Small letters without their accents.
QString folded(const QString& text)
{
    QString result;
    for (const QChar letter : text.normalized(QString::NormalizationForm_D).toCaseFolded())
        if (letter.category() != QChar::Mark_NonSpacing)
            result.append(letter);
    return result;
}

bool beginsWord(const QString& text, qsizetype index)
{
    return text[index].isLetterOrNumber() && (index == 0 || !text[index - 1].isLetterOrNumber());
}

bool hasBeginning(const QString& word, const QString& text)
{
    for (qsizetype place = text.indexOf(word); place >= 0; place = text.indexOf(word, place + 1))
        if (beginsWord(text, place))
            return true;
    return false;
}

/// The best way to find the word's letters in the text, in order: best[i] is that of those so far that ends at letter
/// i of the text.
std::optional<int> matchWord(const QString& word, const QString& text)
{
    std::vector<int> best(static_cast<std::size_t>(text.size()), none);
    for (qsizetype letter = 0; letter < word.size(); ++letter) {
        std::vector<int> next(best.size(), none);
        int before = letter == 0 ? 0 : none; // the best that ends before the letter before
        for (qsizetype place = 0; place < text.size(); ++place) {
            const auto index = static_cast<std::size_t>(place);
            if (text[place] == word[letter]) {
                const int earned = forLetter + (beginsWord(text, place) ? forWordStart : 0);
                if (before != none)
                    next[index] = before + earned;
                if (letter > 0 && place > 0 && best[index - 1] != none)
                    next[index] = std::max(next[index], best[index - 1] + earned + forNeighbour);
            }
            if (letter > 0 && place > 0)
                before = std::max(before, best[index - 1]);
        }
        best = std::move(next);
    }
    const auto found = std::ranges::max_element(best);
    if (found == best.end() || *found == none)
        return std::nullopt;
    return *found + (hasBeginning(word, text) ? forBeginning : 0);
}

constexpr QSize largest(840, 420); ///< room for the longest command beside what it needs, in every language
constexpr int fromEdge = 48;       ///< of the window
constexpr int indexRole = Qt::UserRole;

} // namespace

std::optional<int> fuzzyMatch(const QString& query, const QString& text)
{
    const QString where = folded(text);
    int sum = 0;
    for (const QString& word : folded(query).split(' ', Qt::SkipEmptyParts)) {
        const auto matched = matchWord(word, where);
        if (!matched)
            return std::nullopt;
        sum += *matched;
    }
    return sum;
}

CommandPalette::CommandPalette(QMainWindow& window, Session& session)
    : QFrame(&window), window_(window), session_(session), search_(new QLineEdit), list_(new QTreeWidget)
{
    setObjectName("palette");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    search_->setObjectName("palette.search");
    search_->setPlaceholderText(tr("Type what you want to do"));
    search_->setAccessibleName(tr("Command"));
    search_->setToolTip(tr("A few letters of a command are enough. Enter does it, Esc leaves."));
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
    commands_ = paletteCommands(window_, session_);
    const QSize room = window_.size() - QSize(2 * fromEdge, 2 * fromEdge);
    resize(largest.boundedTo(room));
    move((window_.width() - width()) / 2, fromEdge);
    search_->clear();
    search({});
    show();
    raise();
    search_->setFocus();
}

void CommandPalette::search(const QString& query)
{
    // Of what is equally good the shortest comes first: nothing of it is left over. Else the order stays.
    std::vector<std::tuple<int, qsizetype, std::size_t>> found;
    const auto lengthOf = [&query](const QString& text) { return query.isEmpty() ? 0 : text.size(); };
    for (std::size_t index = 0; index < commands_.size(); ++index)
        if (const auto match = fuzzyMatch(query, commands_[index].text))
            found.emplace_back(-*match, lengthOf(commands_[index].text), index);
    std::ranges::sort(found);
    list_->clear();
    for (const auto& [match, length, index] : found) {
        const PaletteCommand& command = commands_[index];
        auto* item =
            new QTreeWidgetItem(list_, {command.text, command.reason.isEmpty() ? command.keys : command.reason});
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setData(0, indexRole, static_cast<qulonglong>(index));
        item->setToolTip(0, command.text);
        item->setDisabled(!command.reason.isEmpty());
        if (list_->currentItem() == nullptr && !item->isDisabled())
            list_->setCurrentItem(item);
    }
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
    if (before_ != nullptr)
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
