// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/film_dialog.h"

#include "plugins/widgets/number_text.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/session/files.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/first_focus.h"
#include "ui/widgets/form_labels.h"
#include "ui/workbench/film_file.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>

#include <cmath>

namespace tetra {
namespace {

constexpr const char* formatKey = "film/format";
constexpr int trialReduction = 3; ///< of the sides of the picture that tells how long one takes

struct Format {
    const char* suffix;
    const char* text;
    bool video;
};

constexpr std::array formats{
    Format{"png", QT_TRANSLATE_NOOP("tetra::FilmDialog", "Numbered PNG pictures"), false},
    Format{"mp4", QT_TRANSLATE_NOOP("tetra::FilmDialog", "MP4 video (H.264)"), true},
    Format{"webm", QT_TRANSLATE_NOOP("tetra::FilmDialog", "WebM video (VP9)"), true},
};

constexpr int leastWidth = 420;

} // namespace

FilmDialog::FilmDialog(Workbench& workbench, Viewport& viewport, QWidget* parent)
    : QDialog(parent), workbench_(workbench), viewport_(viewport), encoder_(findVideoEncoder()),
      form_(new PictureForm("film", PictureUse::Screen)), format_(new QComboBox), target_(new QLineEdit),
      browse_(new QPushButton(tr("&Browse…"))), hint_(new QLabel), summary_(new QLabel), progress_(new QProgressBar),
      remaining_(new QLabel), save_(nullptr), cancel_(nullptr)
{
    setObjectName("filmOptions");
    setWindowTitle(tr("Save Film"));
    auto* layout = new QVBoxLayout(this);
    layout->addStrut(leastWidth);
    layout->addWidget(form_);
    addTarget(*layout);
    layout->addStretch();
    addProgress(*layout);
    layout->addWidget(makeButtons());
    alignFormLabels(*this);
    connectControls();
    showRunning();
}

void FilmDialog::addTarget(QLayout& layout)
{
    format_->setObjectName("film.format");
    for (const Format& format : formats)
        if (!format.video || !encoder_.isEmpty())
            format_->addItem(tr(format.text), format.suffix);
    format_->setToolTip(encoder_.isEmpty() ? tr("Videos require the program ffmpeg")
                                           : tr("Videos are made by %1").arg(encoder_));
    // What most programs show, where it can be made.
    format_->setCurrentIndex(std::max(0, format_->findData(QSettings().value(formatKey, QStringLiteral("mp4")))));
    target_->setObjectName("film.target");
    target_->setToolTip(tr("Video file, or base name of the numbered pictures"));
    browse_->setObjectName("film.browse");
    browse_->setAutoDefault(false); // Enter in the line above saves
    hint_->setObjectName("film.hint");
    hint_->setWordWrap(true);
    summary_->setObjectName("film.summary");
    summary_->setWordWrap(true);
    auto* place = new QHBoxLayout;
    place->addWidget(target_, 1);
    place->addWidget(browse_);
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins({});
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&Format"), format_);
    auto* label = new QLabel(tr("Fil&e"));
    label->setBuddy(target_);
    form->addRow(label, place);
    form->addRow(QString(), hint_);
    form->addRow(tr("Film"), summary_);
    layout.addWidget(fields);
}

void FilmDialog::addProgress(QLayout& layout)
{
    progress_->setObjectName("film.progress");
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    remaining_->setObjectName("film.remaining");
    layout.addWidget(progress_);
    layout.addWidget(remaining_);
}

QWidget* FilmDialog::makeButtons()
{
    auto* buttons = new QDialogButtonBox;
    save_ = buttons->addButton(tr("&Save"), QDialogButtonBox::ActionRole);
    cancel_ = buttons->addButton(tr("&Cancel"), QDialogButtonBox::ActionRole);
    QPushButton* close = buttons->addButton(tr("Cl&ose"), QDialogButtonBox::RejectRole);
    save_->setObjectName("film.save");
    save_->setDefault(true);
    cancel_->setObjectName("film.cancel");
    close->setObjectName("film.close");
    close->setToolTip(tr("A film that is being written continues"));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    return buttons;
}

void FilmDialog::connectControls()
{
    connect(form_, &PictureForm::changed, this, &FilmDialog::showSummary);
    connect(format_, &QComboBox::activated, this, &FilmDialog::chooseFormat);
    connect(target_, &QLineEdit::textChanged, this, &FilmDialog::lookAtTarget);
    connect(browse_, &QPushButton::clicked, this, &FilmDialog::browse);
    connect(save_, &QPushButton::clicked, this, &FilmDialog::save);
    LongTask& task = workbench_.exporting().savingFilm();
    connect(cancel_, &QPushButton::clicked, &task, &LongTask::cancel);
    connect(&task, &LongTask::started, this, &FilmDialog::showRunning);
    connect(&task, &LongTask::progressed, this, &FilmDialog::showProgress);
    connect(&task, &LongTask::finished, this, &FilmDialog::showRunning);
    connect(&workbench_.exporting(), &Exporting::filmSaved, this, [this] {
        lookAtTarget();
        remaining_->setText(tr("Saved."));
        remaining_->show();
    });
    workbench_.session().whenChanged(ViewPart::Animation, this, &FilmDialog::lookAtTarget);
    connect(&workbench_.session(), &Session::modelChanged, this, &QDialog::reject);
}

void FilmDialog::ask()
{
    form_->setView(pixelsOf(viewport_), workbench_.session().view().annotations);
    if (!workbench_.exporting().savingFilm().running()) {
        target_->setText(workbench_.opening().proposedPath("-film." + format_->currentData().toString()));
        remaining_->clear();
    }
    lookAtTarget();
    showTarget();
    show();
    focusFirst(*this, *save_);
    raise();
    activateWindow();
    lookAtTarget();
    tryOnePicture();
}

/// A text that has become longer has room, once all layouts know of it.
bool FilmDialog::event(QEvent* event)
{
    const bool known = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest)
        resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
    return known;
}

FilmOrder FilmDialog::order() const
{
    FilmOrder order = filmOrder(workbench_, viewport_, form_->settings());
    order.target = filePath(target_->text());
    order.encoder = encoder_;
    return order;
}

void FilmDialog::chooseFormat()
{
    const QFileInfo file(target_->text());
    target_->setText(file.path() + "/" + file.completeBaseName() + "." + format_->currentData().toString());
}

void FilmDialog::browse()
{
    const QString suffix = format_->currentData().toString();
    askForTextTarget(this, "filmDialog", tr("Save Film"), format_->currentText() + " (*." + suffix + ")",
                     target_->text(), [this](const QString& path) { target_->setText(path); });
}

/// A small picture tells how long a large one takes.
void FilmDialog::tryOnePicture()
{
    if (!viewport_.scene())
        return;
    PictureOrder order = pictureOrder(workbench_, viewport_, form_->settings());
    order.width = std::max(1, pixelsOf(viewport_).width() / trialReduction);
    order.height = std::max(1, pixelsOf(viewport_).height() / trialReduction);
    trial_.start([this, order](const Progress& progress) -> std::function<void()> {
        QElapsedTimer clock;
        clock.start();
        const bool drawn = static_cast<bool>(drawPicture(order, progress));
        const double seconds = static_cast<double>(clock.nsecsElapsed()) / 1e9;
        return [this, drawn, each = seconds / order.width / order.height] {
            secondsPerPixel_ = drawn ? each : 0;
            showSummary();
        };
    });
}

void FilmDialog::showSummary()
{
    if (!workbench_.session().model())
        return;
    const Animation& animation = workbench_.session().view().animation;
    const int count = frameCount(animation);
    if (count == 0)
        return summary_->setText(tr("It has no frames yet: add at least two views in the Animation panel."));
    const QString film =
        tr("%1 frames, %2").arg(countText(static_cast<std::uint64_t>(count)), durationText(durationOf(animation)));
    const QSize size = form_->settings().size;
    const double seconds = secondsPerPixel_ * size.width() * size.height() * count;
    summary_->setText(seconds > 0 ? tr("%1; writing takes about %2").arg(film, durationText(seconds)) : film);
}

/// For what the film would take the place of; until that is known nothing is saved.
void FilmDialog::lookAtTarget()
{
    if (!isVisible() || !workbench_.session().model())
        return;
    const int count = frameCount(workbench_.session().view().animation);
    looking_.start([this, target = filePath(target_->text()), count](const Progress&) -> std::function<void()> {
        return [this, found = filesInTheWay(target, count).size()] {
            inTheWay_ = found;
            showTarget();
        };
    });
    showTarget();
}

void FilmDialog::showTarget()
{
    if (!workbench_.session().model())
        return;
    showSummary();
    const int count = frameCount(workbench_.session().view().animation);
    const std::filesystem::path target = filePath(target_->text());
    const QString first = pathText(framePath(target, 0, count).filename());
    QString hint = isVideoFile(target) ? QString() : tr("%1, …").arg(first);
    const bool replaces = inTheWay_ > 0 && !looking_.running();
    if (replaces)
        hint = tr("Files with this name already exist and will be replaced: %1.").arg(countText(inTheWay_));
    hint_->setText(hint);
    save_->setText(replaces ? tr("&Replace and Save") : tr("&Save"));
    save_->setEnabled(count > 0 && !target_->text().isEmpty() && !workbench_.exporting().savingFilm().running() &&
                      !looking_.running());
}

void FilmDialog::showRunning()
{
    const bool running = workbench_.exporting().savingFilm().running();
    for (QWidget* widget : std::initializer_list<QWidget*>{form_, format_, target_, browse_})
        widget->setEnabled(!running);
    cancel_->setEnabled(running);
    progress_->setVisible(running);
    progress_->setValue(0);
    remaining_->setVisible(running);
    if (running)
        remaining_->setText(tr("Starting…"));
    showTarget();
}

void FilmDialog::showProgress(const TaskProgress& progress)
{
    progress_->setValue(static_cast<int>(std::lround(1000 * progress.fraction)));
    const int frame = std::min(frames_, static_cast<int>(progress.fraction * frames_ + 1));
    const QString text = tr("Frame %1 of %2").arg(frame).arg(frames_);
    remaining_->setText(
        progress.remainingSeconds ? tr("%1, about %2 left").arg(text, durationText(*progress.remainingSeconds)) : text);
}

void FilmDialog::save()
{
    if (!workbench_.session().model() || workbench_.exporting().savingFilm().running())
        return;
    form_->remember();
    QSettings().setValue(formatKey, format_->currentData());
    trial_.cancel();
    frames_ = frameCount(workbench_.session().view().animation);
    workbench_.exporting().saveFilm(order());
}

} // namespace tetra
