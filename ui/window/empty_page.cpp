// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/empty_page.h"

#include "plugins/widgets/icons.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace tetra {
namespace {

constexpr qsizetype mostRecent = 5;
constexpr int signSide = 72;
constexpr int textWidth = 440;

} // namespace

EmptyPage::EmptyPage(QWidget* parent)
    : QWidget(parent), title_(new QLabel), text_(new QLabel), open_(new QPushButton(tr("Open…"))),
      recentTitle_(new QLabel(tr("Opened last"))), recent_(new QVBoxLayout)
{
    setObjectName("empty");
    title_->setObjectName("empty.title");
    text_->setObjectName("empty.text");
    open_->setObjectName("empty.open");
    auto* sign = new QLabel;
    sign->setPixmap(programIcon().pixmap(QSize(signSide, signSide), devicePixelRatioF()));

    QFont large = title_->font();
    large.setPointSizeF(large.pointSizeF() * 1.6);
    title_->setFont(large);
    text_->setWordWrap(true);
    text_->setFixedWidth(textWidth);
    text_->setAlignment(Qt::AlignHCenter);
    open_->setIcon(glyphIcon(Glyph::Open));
    open_->setDefault(true);
    recentTitle_->setForegroundRole(QPalette::PlaceholderText);
    recent_->setSpacing(0);

    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addStretch(2);
    layout->addWidget(sign, 0, Qt::AlignHCenter);
    layout->addWidget(title_, 0, Qt::AlignHCenter);
    auto* textRow = new QHBoxLayout; // unlike an aligned item, it gives the text the height that its width needs
    textRow->addStretch();
    textRow->addWidget(text_);
    textRow->addStretch();
    layout->addLayout(textRow);
    layout->addWidget(open_, 0, Qt::AlignHCenter);
    layout->addSpacing(16);
    layout->addWidget(recentTitle_, 0, Qt::AlignHCenter);
    layout->addLayout(recent_);
    layout->addStretch(3);
    connect(open_, &QPushButton::clicked, this, &EmptyPage::openClicked);
    invite({});
}

void EmptyPage::invite(const QStringList& recentFiles)
{
    title_->setText(tr("Open a dataset or a model"));
    text_->setText(tr("Drop a file here: a dataset (a volume, a grid, a mesh or points) to build a model of, a "
                      "finished .tan model or a session."));
    open_->show();
    showRecent(recentFiles.mid(0, mostRecent));
}

void EmptyPage::tell(const QString& title, const QString& text)
{
    title_->setText(title);
    text_->setText(text);
    open_->hide();
    showRecent({});
}

void EmptyPage::showRecent(const QStringList& files)
{
    while (QLayoutItem* item = recent_->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    recentTitle_->setVisible(!files.isEmpty());
    for (const QString& path : files) {
        auto* button = new QPushButton(QFileInfo(path).fileName().replace('&', "&&"));
        button->setObjectName("empty.recent");
        button->setFlat(true);
        button->setToolTip(path);
        button->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
        connect(button, &QPushButton::clicked, this, [this, path] { emit recentClicked(path); });
        recent_->addWidget(button, 0, Qt::AlignHCenter);
    }
}

} // namespace tetra
