// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/lost_offers.h"

#include "plugins/widgets/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

constexpr qsizetype mostOffers = 3;
constexpr int offerIconSide = 20;
constexpr QColor offerColour(0, 114, 178);

/// Lines may end within long names of files, and not behind the first slash of a path.
QString breakable(QString text)
{
    constexpr char16_t mayBreak = u'\u200b', keepTogether = u'\u2060';
    static const QRegularExpression ends("(?<! )([-_/])(?=[^-_/ ])");
    static const QRegularExpression first(" /");
    return text.replace(ends, QString("\\1") + QChar(mayBreak)).replace(first, QString(" /") + QChar(keepTogether));
}

} // namespace

LostOffers::LostOffers(QWidget* parent) : QFrame(parent), rows_(new QVBoxLayout(this))
{
    setObjectName("lost");
    setAccessibleName(tr("Sessions to restore"));
    rows_->setContentsMargins(12, 8, 8, 8);
    hide();
}

void LostOffers::setOffers(const QList<LostOffer>& offers)
{
    while (QLayoutItem* item = rows_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (qsizetype i = 0; i < std::min(offers.size(), mostOffers); ++i)
        rows_->addWidget(makeRow(offers[i], static_cast<int>(i)));
    setVisible(!offers.isEmpty());
}

QWidget* LostOffers::makeRow(const LostOffer& offer, int index)
{
    auto* row = new QWidget;
    auto* sign = new QLabel;
    sign->setPixmap(glyphIcon(Glyph::Information).pixmap(QSize(offerIconSide, offerIconSide), devicePixelRatioF()));
    auto* text = new QLabel("<b>" + breakable(offer.text).toHtmlEscaped() + "</b><br>" +
                            breakable(offer.detail).toHtmlEscaped());
    text->setObjectName("lost.text");
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    auto* restore = new QPushButton(tr("&Restore"));
    restore->setObjectName("lost.restore");
    restore->setToolTip(tr("Open the model with its view restored. The saved view is kept until that has succeeded."));
    restore->setAccessibleName(tr("Restore %1").arg(offer.model));
    restore->setAccessibleDescription(offer.detail);
    auto* discard = new QPushButton(tr("&Discard"));
    discard->setObjectName("lost.discard");
    discard->setToolTip(tr("Discard the saved view (the model file is kept)"));
    discard->setAccessibleName(tr("Discard %1").arg(offer.model));
    discard->setAccessibleDescription(offer.detail);
    connect(restore, &QPushButton::clicked, this, [this, index] { emit restoreClicked(index); });
    connect(discard, &QPushButton::clicked, this, [this, index] { emit discardClicked(index); });

    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    layout->addWidget(sign, 0, Qt::AlignTop);
    layout->addWidget(text, 1);
    layout->addWidget(restore);
    layout->addWidget(discard);
    return row;
}

/// As the bar of messages has it.
void LostOffers::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setOpacity(0.2);
    painter.fillRect(rect(), offerColour);
    painter.setOpacity(1);
    painter.fillRect(QRect(0, 0, 3, height()), offerColour);
}

} // namespace tetra
