// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/empty_page.h"

#include "plugins/widgets/icons.h"
#include "ui/opening/sample_models.h"
#include "ui/session/files.h"
#include "ui/window/lost_offers.h"
#include "ui/work/long_task.h"

#include <tan/open.h>

#include <QCommandLinkButton>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace tetra {
namespace {

constexpr qsizetype mostRecent = 4;
constexpr int signSide = 56;
constexpr int textWidth = 440;
constexpr int lostWidth = 560;
constexpr int samplesInRow = 5;
constexpr int recentInRow = 2;
constexpr int recentLetters = 46;
constexpr int leastLetters = 24; ///< in a row of the page
constexpr int frameInset = 14;
constexpr QSize thumbnailSize(thumbnailWidth / 2, thumbnailHeight / 2);

/// The picture of a sample until it is drawn.
QIcon blankIcon()
{
    QPixmap blank(thumbnailSize);
    blank.fill(Qt::transparent);
    return QIcon(blank);
}

/// "~/data" for what lies in the user's folder.
QString folderText(const QString& path)
{
    const bool isRemote = isAddress(path.toStdString());
    const QString folder = isRemote ? QFileInfo(path).path() : QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    return QDir::toNativeSeparators(folder.startsWith(home + '/') ? "~" + folder.mid(home.size()) : folder);
}

QLabel* makeHeading(const QString& text)
{
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setAlignment(Qt::AlignHCenter);
    return label;
}

} // namespace

EmptyPage::EmptyPage(LongTask& sampling, QWidget* parent)
    : QWidget(parent), title_(new QLabel), text_(new QLabel), open_(new QPushButton(tr("Open…"))),
      lost_(new LostOffers), recentBox_(new QWidget), recent_(new QGridLayout), description_(new QLabel),
      grid_(new QGridLayout), samples_(makeSamples(sampling))
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
    title_->setWordWrap(true);
    title_->setAlignment(Qt::AlignHCenter);
    text_->setWordWrap(true);
    text_->setMaximumWidth(textWidth);
    text_->setAlignment(Qt::AlignHCenter);
    open_->setIcon(glyphIcon(Glyph::Open));
    open_->setDefault(true);
    open_->setToolTip(tr("Open a dataset, a model or a session (Ctrl+O)"));
    auto* recentLayout = new QVBoxLayout(recentBox_);
    recentLayout->setContentsMargins({});
    recentLayout->addWidget(makeHeading(tr("Recent files")));
    recentLayout->addLayout(recent_);
    recent_->setSpacing(0);

    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(frameInset, frameInset, frameInset, frameInset);
    layout->setSpacing(10);
    layout->addStretch(2);
    layout->addWidget(sign, 0, Qt::AlignHCenter);
    layout->addWidget(title_);
    auto* textRow = new QHBoxLayout; // unlike an aligned item, it gives the text the height that its width needs
    textRow->addStretch(1);
    textRow->addWidget(text_, textWidth);
    textRow->addStretch(1);
    layout->addLayout(textRow);
    layout->addWidget(open_, 0, Qt::AlignHCenter);
    lost_->setMaximumWidth(lostWidth);
    auto* lostRow = new QHBoxLayout;
    lostRow->addStretch(1);
    lostRow->addWidget(lost_, lostWidth);
    lostRow->addStretch(1);
    layout->addLayout(lostRow);
    layout->addWidget(recentBox_, 0, Qt::AlignHCenter);
    layout->addWidget(samples_, 0, Qt::AlignHCenter);
    layout->addStretch(3);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(frameInset + 1, frameInset + 1, frameInset + 1, frameInset + 1); // the frame is seen
    auto* scrolled = new QScrollArea; // a small window has less room than recent files and samples need
    scrolled->setWidget(content);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setMinimumWidth(leastLetters * fontMetrics().averageCharWidth());
    scrolled->setFocusPolicy(Qt::NoFocus);
    scrolled->viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
    whole->addWidget(scrolled);
    connect(open_, &QPushButton::clicked, this, &EmptyPage::openClicked);
    invite({});
}

QWidget* EmptyPage::makeSamples(LongTask& sampling)
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins({});
    column->addWidget(makeHeading(tr("Or try a sample")));
    grid_->setSpacing(4);
    const std::vector<SampleCard> cards = sampleCards();
    int width = 0;
    for (const SampleCard& card : cards)
        width = std::max(width, fontMetrics().horizontalAdvance(card.title));
    width = std::max(width, thumbnailSize.width()) + 2 * fontMetrics().averageCharWidth();
    int index = 0;
    for (const SampleCard& card : cards) {
        auto* button = new QToolButton;
        button->setText(QString(card.title).replace('&', "&&"));
        button->setObjectName("empty.sample." + QString::fromStdString(card.name));
        button->setIcon(blankIcon());
        button->setIconSize(thumbnailSize);
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setMinimumWidth(width);
        button->setToolTip(card.description);
        button->setAccessibleName(card.title);
        button->setAccessibleDescription(card.description);
        button->installEventFilter(this);
        connect(button, &QToolButton::clicked, this,
                [this, name = QString::fromStdString(card.name)] { emit sampleClicked(name); });
        grid_->addWidget(button, index / samplesInRow, index % samplesInRow);
        sampleButtons_.append(button);
        ++index;
    }
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addLayout(grid_);
    row->addStretch();
    column->addLayout(row);
    description_->setObjectName("empty.sample.description");
    description_->setForegroundRole(QPalette::PlaceholderText);
    description_->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    description_->setWordWrap(true);
    setDescriptionWidth(samplesInRow * (width + grid_->horizontalSpacing()));
    describe({});
    column->addWidget(description_, 0, Qt::AlignHCenter);
    const auto enable = [this](bool enabled) {
        for (QToolButton* button : sampleButtons_)
            button->setEnabled(enabled);
    };
    connect(&sampling, &LongTask::started, box, [enable] { enable(false); });
    connect(&sampling, &LongTask::finished, box, [enable] { enable(true); });
    return box;
}

/// It is as high as the longest text, so that nothing moves when another one is told.
void EmptyPage::setDescriptionWidth(int width)
{
    int height = 0;
    for (const SampleCard& card : sampleCards())
        height = std::max(
            height, fontMetrics().boundingRect(0, 0, width - 8, width, Qt::TextWordWrap, card.description).height());
    description_->setFixedWidth(width);
    description_->setMinimumHeight(height + 4);
}

void EmptyPage::describe(const QString& text)
{
    description_->setText(text.isEmpty() ? tr("Samples are computed when you choose them; nothing is downloaded.")
                                         : text);
}

void EmptyPage::setThumbnail(const std::string& sample, const QImage& picture)
{
    QPixmap pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(2);
    if (auto* button = findChild<QToolButton*>("empty.sample." + QString::fromStdString(sample)))
        button->setIcon(QIcon(pixmap));
}

void EmptyPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!samples_->isHidden())
        emit samplesShown();
}

/// What a sample is, is told while it is pointed at or has the keys.
bool EmptyPage::eventFilter(QObject* watched, QEvent* event)
{
    const auto* button = qobject_cast<QToolButton*>(watched);
    if (button != nullptr && (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn))
        describe(button->accessibleDescription());
    else if (button != nullptr && (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut))
        describe({});
    return QWidget::eventFilter(watched, event);
}

void EmptyPage::invite(const QStringList& recentFiles)
{
    title_->setText(tr("Open a dataset or a model"));
    text_->setText(
        tr("Drop a file: a dataset (a volume, a grid, a mesh or points), a .tan model or a session. TAn shows "
           "large data at any accuracy, with a known error."));
    open_->show();
    samples_->show();
    showRecent(recentFiles.mid(0, mostRecent));
}

void EmptyPage::tell(const QString& title, const QString& text)
{
    title_->setText(title);
    text_->setText(text);
    open_->hide();
    samples_->hide();
    showRecent({});
}

void EmptyPage::setDropping(bool dropping)
{
    dropping_ = dropping;
    update();
}

void EmptyPage::showRecent(const QStringList& files)
{
    while (QLayoutItem* item = recent_->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    recentBox_->setVisible(!files.isEmpty());
    const int width = recentLetters * fontMetrics().averageCharWidth();
    const auto shortened = [&](const QString& text) {
        const int room = width - 5 * fontMetrics().averageCharWidth(); // between the button's margins
        return fontMetrics().elidedText(text, Qt::ElideMiddle, room).replace('&', "&&");
    };
    for (const QString& path : files) {
        const QString shown = shownPlace(filePath(path));
        auto* button = new QCommandLinkButton(shortened(shownName(filePath(path))), shortened(folderText(shown)));
        button->setObjectName("empty.recent");
        button->setIcon({});
        button->setToolTip(shown);
        button->setFixedWidth(width);
        button->setFont(font()); // the style makes the name bold, and only that
        connect(button, &QPushButton::clicked, this, [this, path] { emit recentClicked(path); });
        recent_->addWidget(button, recent_->count() / recentInRow, recent_->count() % recentInRow);
    }
}

/// As many samples in a row as there is room for.
void EmptyPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int cell = sampleButtons_.front()->minimumWidth() + grid_->horizontalSpacing();
    const int columns = std::clamp((width() - 4 * frameInset) / cell, 1, samplesInRow);
    if (std::exchange(columns_, columns) == columns)
        return;
    for (int index = 0; index < sampleButtons_.size(); ++index)
        grid_->addWidget(sampleButtons_[index], index / columns, index % columns); // moves it
    setDescriptionWidth(columns * cell);
}

/// The frame says that the whole page takes files.
void EmptyPage::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = palette().color(dropping_ ? QPalette::Highlight : QPalette::PlaceholderText);
    painter.setPen(QPen(colour, dropping_ ? 3 : 1.5, Qt::DashLine));
    if (dropping_) {
        QColor filling = colour;
        filling.setAlpha(30);
        painter.setBrush(filling);
    }
    painter.drawRoundedRect(QRectF(rect()).adjusted(frameInset, frameInset, -frameInset, -frameInset), 12, 12);
}

} // namespace tetra
