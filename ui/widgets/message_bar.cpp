// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "plugins/widgets/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace tetra {
namespace {

/// As many as leave room for the picture; the others come up when these are taken away.
constexpr qsizetype mostShown = 3;
constexpr QColor amber(230, 159, 0);
constexpr int iconSide = 20;

} // namespace

MessageRow::MessageRow(const QString& text, QWidget* parent)
    : QFrame(parent), text_(text), count_(new QLabel), layout_(new QHBoxLayout(this))
{
    setObjectName("message");
    auto* sign = new QLabel;
    sign->setPixmap(glyphIcon(Glyph::Warning).pixmap(QSize(iconSide, iconSide), devicePixelRatioF()));
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
    count_->setText(tr("%1 times").arg(++times_));
    count_->show();
}

void MessageRow::paintEvent(QPaintEvent* event)
{
    QFrame::paintEvent(event);
    QPainter painter(this);
    painter.setOpacity(0.2);
    painter.fillRect(rect(), amber);
    painter.setOpacity(1);
    painter.fillRect(QRect(0, 0, 3, height()), amber);
    painter.fillRect(QRect(0, height() - 1, width(), 1), palette().color(QPalette::Mid));
}

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), layout_(new QVBoxLayout(this)), more_(new QLabel)
{
    setObjectName("messages");
    layout_->setContentsMargins({});
    layout_->setSpacing(0);
    more_->setObjectName("messages.more");
    more_->setContentsMargins(10, 4, 6, 4);
    layout_->addWidget(more_);
    showNewest();
}

void MessageBar::add(const QString& text)
{
    const auto same = std::ranges::find_if(rows_, [&](const MessageRow* row) { return row->text() == text; });
    if (same != rows_.end()) {
        (*same)->countAgain();
        return;
    }
    auto* row = new MessageRow(text);
    connect(row, &MessageRow::dismissed, this, [this, row] { dismiss(row); });
    insert(row);
}

void MessageBar::ask(const QString& text, const QString& answer, const std::function<void()>& accepted,
                     const std::function<void()>& declined)
{
    auto* row = new MessageRow(text);
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
    layout_->insertWidget(0, row);
    rows_.prepend(row);
    showNewest();
}

QStringList MessageBar::texts() const
{
    QStringList result;
    for (const MessageRow* row : rows_)
        result.append(row->text());
    return result;
}

void MessageBar::clear()
{
    while (!rows_.isEmpty())
        dismiss(rows_.first());
}

void MessageBar::dismiss(MessageRow* row)
{
    rows_.removeOne(row);
    layout_->removeWidget(row);
    row->deleteLater();
    showNewest();
}

void MessageBar::showNewest()
{
    for (qsizetype i = 0; i < rows_.size(); ++i)
        rows_[i]->setVisible(i < mostShown);
    const auto hidden = static_cast<int>(rows_.size() - mostShown);
    more_->setText(tr("%1 more").arg(hidden));
    more_->setVisible(hidden > 0);
    setVisible(!rows_.isEmpty());
}

} // namespace tetra
