// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/empty_page.h"

#include "core/data/analytic_fields.h"
#include "plugins/widgets/icons.h"
#include "ui/session/plugin_texts.h"
#include "ui/window/lost_offers.h"
#include "ui/window/task_line.h"

#include <QCommandLinkButton>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace tetra {
namespace {

constexpr qsizetype mostRecent = 4;
constexpr int signSide = 56;
constexpr int textWidth = 440;
constexpr int lostWidth = 560;
constexpr int samplesInRow = 5;
constexpr int frameInset = 14;

/// "~/data" for what lies in the user's folder.
QString folderText(const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
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
      lost_(new LostOffers), recentBox_(new QWidget), recent_(new QVBoxLayout), samples_(makeSamples(sampling))
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
    open_->setToolTip(tr("Open a dataset, a model or a session (Ctrl+O)"));
    auto* recentLayout = new QVBoxLayout(recentBox_);
    recentLayout->setContentsMargins({});
    recentLayout->addWidget(makeHeading(tr("Opened last")));
    recentLayout->addLayout(recent_);
    recent_->setSpacing(0);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2 * frameInset, 2 * frameInset, 2 * frameInset, 2 * frameInset);
    layout->setSpacing(10);
    layout->addStretch(2);
    layout->addWidget(sign, 0, Qt::AlignHCenter);
    layout->addWidget(title_, 0, Qt::AlignHCenter);
    auto* textRow = new QHBoxLayout; // unlike an aligned item, it gives the text the height that its width needs
    textRow->addStretch();
    textRow->addWidget(text_);
    textRow->addStretch();
    layout->addLayout(textRow);
    layout->addWidget(open_, 0, Qt::AlignHCenter);
    lost_->setFixedWidth(lostWidth);
    auto* lostRow = new QHBoxLayout;
    lostRow->addStretch();
    lostRow->addWidget(lost_);
    lostRow->addStretch();
    layout->addLayout(lostRow);
    layout->addSpacing(8);
    layout->addWidget(recentBox_, 0, Qt::AlignHCenter);
    layout->addWidget(samples_, 0, Qt::AlignHCenter);
    layout->addStretch(3);
    connect(open_, &QPushButton::clicked, this, &EmptyPage::openClicked);
    invite({});
}

QWidget* EmptyPage::makeSamples(LongTask& sampling)
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins({});
    column->addWidget(makeHeading(tr("Or look at a sample, which is made now")));
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    int index = 0;
    for (const SampleKind& kind : sampleKinds()) {
        const QString name = QString::fromUtf8(kind.name.data(), static_cast<qsizetype>(kind.name.size()));
        auto* button = new QPushButton(name);
        button->setObjectName("empty.sample." + name);
        button->setToolTip(pluginText(std::string(kind.description)));
        button->setAccessibleDescription(button->toolTip());
        connect(button, &QPushButton::clicked, this, [this, name] { emit sampleClicked(name); });
        grid->addWidget(button, index / samplesInRow, index % samplesInRow);
        ++index;
    }
    column->addLayout(grid);
    column->addWidget(new TaskLine("empty.sampling", tr("Making the sample"), sampling), 0, Qt::AlignHCenter);
    connect(&sampling, &LongTask::started, box, [box] {
        for (QPushButton* button : box->findChildren<QPushButton*>())
            button->setEnabled(false);
    });
    connect(&sampling, &LongTask::finished, box, [box] {
        for (QPushButton* button : box->findChildren<QPushButton*>())
            button->setEnabled(true);
    });
    return box;
}

void EmptyPage::invite(const QStringList& recentFiles)
{
    title_->setText(tr("Open a dataset or a model"));
    text_->setText(tr("Drop a file here: a dataset (a volume, a grid, a mesh or points) to build a model of, a "
                      "finished .tan model or a session."));
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
    for (const QString& path : files) {
        auto* button =
            new QCommandLinkButton(QFileInfo(path).fileName().replace('&', "&&"), folderText(path).replace('&', "&&"));
        button->setObjectName("empty.recent");
        button->setIcon({});
        button->setToolTip(path);
        button->setMinimumWidth(textWidth);
        button->setFont(font()); // the style makes the name bold, and only that
        connect(button, &QPushButton::clicked, this, [this, path] { emit recentClicked(path); });
        recent_->addWidget(button);
    }
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
