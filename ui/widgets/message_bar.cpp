// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "plugins/widgets/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>

#include <algorithm>
#include <limits>

namespace tetra {
namespace {

/// As many as leave room for the picture; the others come up when these are taken away.
constexpr qsizetype mostShown = 3;
constexpr QColor amber(230, 159, 0);
constexpr QColor blue(0, 114, 178);
constexpr int iconSide = 20;

QColor colourOf(MessageKind kind)
{
    return kind == MessageKind::Problem ? amber : blue;
}

} // namespace

MessageRow::MessageRow(const QString& text, MessageSubject subject, MessageKind kind)
    : text_(text), subject_(subject), kind_(kind), count_(new QLabel), layout_(new QHBoxLayout(this))
{
    setObjectName("message");
    auto* sign = new QLabel;
    const QIcon icon = glyphIcon(kind == MessageKind::Problem ? Glyph::Warning : Glyph::Information);
    sign->setPixmap(icon.pixmap(QSize(iconSide, iconSide), devicePixelRatioF()));
    auto* label = new QLabel(text);
    label->setObjectName("message.text");
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* close = new QToolButton;
    close->setObjectName("message.close");
    close->setIcon(glyphIcon(Glyph::Close));
    close->setAutoRaise(true);
    close->setToolTip(tr("Dismiss this message"));
    close->setAccessibleName(tr("Dismiss this message"));
    count_->setObjectName("message.count");
    count_->hide();

    layout_->setContentsMargins(10, 6, 6, 6);
    layout_->addWidget(sign, 0, Qt::AlignTop);
    layout_->addWidget(label, 1);
    layout_->addWidget(count_, 0, Qt::AlignTop);
    layout_->addWidget(close, 0, Qt::AlignTop);
    connect(close, &QToolButton::clicked, this, &MessageRow::dismissed);
}

QPushButton& MessageRow::addButton(const QString& text)
{
    auto* button = new QPushButton(text);
    layout_->insertWidget(layout_->count() - 1, button, 0, Qt::AlignTop);
    return *button;
}

void MessageRow::countAgain()
{
    isOld_ = false;
    count_->setText(tr("%1 times").arg(++times_));
    count_->show();
}

void MessageRow::paintEvent(QPaintEvent* event)
{
    QFrame::paintEvent(event);
    QPainter painter(this);
    painter.setOpacity(0.2);
    painter.fillRect(rect(), colourOf(kind_));
    painter.setOpacity(1);
    painter.fillRect(QRect(0, 0, 3, height()), colourOf(kind_));
    painter.fillRect(QRect(0, height() - 1, width(), 1), palette().color(QPalette::Mid));
}

MessageList::MessageList() : rows_(nullptr)
{
    auto* content = new QWidget;
    rows_ = new QVBoxLayout(content);
    rows_->setContentsMargins({});
    rows_->setSpacing(0);
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    showAll(false);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void MessageList::insert(MessageRow* row)
{
    rows_->insertWidget(0, row);
}

void MessageList::showAll(bool all)
{
    showsAll_ = all;
    setVerticalScrollBarPolicy(all ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
    verticalScrollBar()->setValue(0);
}

int MessageList::heightForWidth(int width) const
{
    const int most = showsAll_ ? window()->height() / 2 : std::numeric_limits<int>::max();
    return std::min(most, rows_->totalHeightForWidth(width));
}

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent), list_(new MessageList), below_(new QWidget), more_(new QToolButton)
{
    setObjectName("messages");
    more_->setObjectName("messages.more");
    more_->setToolTip(tr("Show or hide the older messages"));
    auto* closeAll = new QToolButton;
    closeAll->setObjectName("messages.closeAll");
    closeAll->setText(tr("Close All"));
    closeAll->setToolTip(tr("Dismiss all messages"));
    for (QToolButton* button : {more_, closeAll})
        button->setAutoRaise(true);
    auto* buttons = new QHBoxLayout(below_);
    buttons->setContentsMargins(6, 1, 6, 1);
    buttons->addWidget(more_);
    buttons->addStretch();
    buttons->addWidget(closeAll);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->setSpacing(0);
    layout->addWidget(list_);
    layout->addWidget(below_);
    connect(more_, &QToolButton::clicked, this, [this] {
        list_->showAll(!list_->showsAll());
        showRows();
    });
    connect(closeAll, &QToolButton::clicked, this, &MessageBar::clear);
    showRows();
}

void MessageBar::add(const QString& text, MessageSubject subject)
{
    add(text, subject, MessageKind::Problem);
}

void MessageBar::tell(const QString& text, MessageSubject subject)
{
    add(text, subject, MessageKind::News);
}

void MessageBar::add(const QString& text, MessageSubject subject, MessageKind kind)
{
    const auto same = std::ranges::find_if(rows_, [&](const MessageRow* row) { return row->text() == text; });
    if (same != rows_.end()) {
        (*same)->countAgain();
        return;
    }
    auto* row = new MessageRow(text, subject, kind);
    connect(row, &MessageRow::dismissed, this, [this, row] { dismiss(row); });
    insert(row);
}

void MessageBar::ask(const QString& text, const QString& answer, const std::function<void()>& accepted,
                     const std::function<void()>& declined, MessageSubject subject, MessageKind kind)
{
    auto* row = new MessageRow(text, subject, kind);
    QPushButton& button = row->addButton(answer);
    button.setObjectName("message.answer");
    connect(&button, &QPushButton::clicked, this, [this, row, accepted] {
        dismiss(row);
        accepted();
    });
    connect(row, &MessageRow::dismissed, this, [this, row, declined] {
        dismiss(row);
        declined();
    });
    insert(row);
}

void MessageBar::insert(MessageRow* row)
{
    list_->insert(row);
    rows_.prepend(row);
    showRows();
}

QStringList MessageBar::texts() const
{
    QStringList result;
    for (const MessageRow* row : rows_)
        result.append(row->text());
    return result;
}

void MessageBar::remove(const QString& text)
{
    const auto found = std::ranges::find(rows_, text, &MessageRow::text);
    if (found != rows_.end())
        dismiss(*found);
}

void MessageBar::clear()
{
    while (!rows_.isEmpty())
        dismiss(rows_.first());
}

void MessageBar::markOld()
{
    for (MessageRow* row : rows_)
        row->markOld();
}

void MessageBar::clearOld()
{
    const QList<MessageRow*> rows = rows_;
    for (MessageRow* row : rows)
        if (row->isOld())
            dismiss(row);
}

void MessageBar::dismiss(MessageRow* row)
{
    rows_.removeOne(row);
    row->hide();
    row->deleteLater();
    showRows();
}

void MessageBar::showRows()
{
    // What is said of files that were tried before makes room for the newest.
    const auto isFolded = [this](qsizetype i) { return i >= mostShown || (i > 0 && rows_[i]->isOld()); };
    int hidden = 0;
    for (qsizetype i = 0; i < rows_.size(); ++i)
        hidden += isFolded(i) ? 1 : 0;
    if (hidden == 0)
        list_->showAll(false);
    for (qsizetype i = 0; i < rows_.size(); ++i)
        rows_[i]->setVisible(list_->showsAll() || !isFolded(i));
    more_->setText(list_->showsAll() ? tr("Show fewer") : tr("Show %1 more").arg(hidden));
    more_->setVisible(hidden > 0);
    below_->setVisible(rows_.size() > 1);
    setVisible(!rows_.isEmpty());
    list_->updateGeometry();
}

} // namespace tetra
