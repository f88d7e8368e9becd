// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/animation_panel.h"

#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "plugins/widgets/value_box.h"
#include "ui/panels/key_frame_list.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/form_labels.h"

#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStackedWidget>

#include <cmath>

namespace tetra {
namespace {

constexpr int mostRate = 120;
constexpr int playInterval = 16; // milliseconds

template <class Box, class Number> void showNumber(Box& box, Number number)
{
    const QSignalBlocker blocker(box);
    box.setValue(number);
}

} // namespace

AnimationPanel::AnimationPanel(Workbench& workbench, Viewport& viewport, QWidget* parent)
    : QWidget(parent), workbench_(workbench), viewport_(viewport), kind_(new QComboBox), pages_(new QStackedWidget),
      axis_(new QComboBox), degrees_(new ValueBox), frames_(new QSpinBox), rate_(new QSpinBox), play_(new QPushButton),
      position_(new QSlider(Qt::Horizontal)), summary_(new QLabel), write_(new QPushButton(tr("&Save Film…")))
{
    setObjectName("animation");
    playing_.setInterval(playInterval);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(makeContent()));
    connectControls();
    showModel();
}

QWidget* AnimationPanel::makeContent()
{
    kind_->setObjectName("animation.kind");
    kind_->setAccessibleName(tr("Kind of film"));
    kind_->addItems({tr("Turntable"), tr("Key frames")});
    kind_->setToolTip(tr("Turntable, or a camera path through key frames"));
    rate_->setObjectName("animation.rate");
    rate_->setAccessibleName(tr("Frames per second"));
    rate_->setRange(1, mostRate);
    rate_->setAlignment(Qt::AlignRight);
    rate_->setSuffix(tr(" frames/s"));
    rate_->setToolTip(tr("Frames per second of the film"));
    pages_->addWidget(makeTurntable());
    pages_->addWidget(new KeyFrameList(workbench_.session()));
    summary_->setObjectName("animation.summary");
    write_->setObjectName("animation.save");
    write_->setToolTip(tr("Write it as pictures or a video"));

    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    auto* head = new QFormLayout;
    head->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    head->addRow(tr("&Kind"), kind_);
    head->addRow(tr("Ra&te"), rate_);
    column->addLayout(head);
    column->addWidget(pages_, 1);
    column->addLayout(makePlayer());
    auto* foot = new QHBoxLayout;
    foot->addWidget(summary_, 1);
    foot->addWidget(write_);
    column->addLayout(foot);
    alignFormLabels(*content);
    return content;
}

QWidget* AnimationPanel::makeTurntable()
{
    axis_->setObjectName("animation.axis");
    axis_->setAccessibleName(tr("Axis to turn around"));
    axis_->addItems({tr("Around the vertical axis"), tr("Up and down")});
    axis_->setToolTip(tr("Up and down: the camera returns to its start and stops at the poles"));
    degrees_->setObjectName("animation.degrees");
    degrees_->setAccessibleName(tr("Angle to turn by"));
    degrees_->setValueRange(-3600, 3600);
    degrees_->setSuffix(tr("°"));
    degrees_->setSingleStep(90);
    degrees_->setToolTip(tr("Angle to turn by, in degrees; negative turns the other way"));
    frames_->setObjectName("animation.frames");
    frames_->setAccessibleName(tr("Number of frames"));
    frames_->setRange(1, mostFrames);
    frames_->setAlignment(Qt::AlignRight);
    frames_->setToolTip(tr("Number of frames of the film"));
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins({});
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("A&xis"), axis_);
    form->addRow(tr("An&gle"), degrees_);
    form->addRow(tr("&Frames"), frames_);
    return page;
}

QLayout* AnimationPanel::makePlayer()
{
    play_->setObjectName("animation.play");
    position_->setObjectName("animation.position");
    position_->setAccessibleName(tr("Frame"));
    position_->setToolTip(tr("Frame shown"));
    auto* row = new QHBoxLayout;
    row->addWidget(play_);
    row->addWidget(position_, 1);
    return row;
}

void AnimationPanel::connectControls()
{
    connect(kind_, &QComboBox::activated, this, [this](int index) {
        edit([index](Animation& animation) { animation.kind = static_cast<Animation::Kind>(index); });
    });
    connect(axis_, &QComboBox::activated, this, [this](int index) {
        edit([index](Animation& animation) { animation.turntable.axis = static_cast<Turntable::Axis>(index); });
    });
    connect(degrees_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
        edit([degrees](Animation& animation) { animation.turntable.degrees = degrees; });
    });
    connect(frames_, &QSpinBox::valueChanged, this,
            [this](int frames) { edit([frames](Animation& animation) { animation.turntable.frames = frames; }); });
    connect(rate_, &QSpinBox::valueChanged, this,
            [this](int rate) { edit([rate](Animation& animation) { animation.framesPerSecond = rate; }); });
    for (QAbstractSpinBox* box : std::initializer_list<QAbstractSpinBox*>{degrees_, frames_, rate_})
        box->setKeyboardTracking(false);
    connect(play_, &QPushButton::clicked, this, &AnimationPanel::play);
    connect(&playing_, &QTimer::timeout, this, &AnimationPanel::playOn);
    connect(position_, &QSlider::sliderPressed, &playing_, &QTimer::stop);
    connect(position_, &QSlider::valueChanged, this, &AnimationPanel::showFrame);
    connect(position_, &QSlider::sliderReleased, this, &AnimationPanel::stop);
    connect(write_, &QPushButton::clicked, this, &AnimationPanel::filmWanted);
    connect(&viewport_, &Viewport::previewChanged, this, [this](bool on) {
        if (!on)
            stop(); // the camera was moved
    });
    const Session& session = workbench_.session();
    connect(&session, &Session::modelChanged, this, &AnimationPanel::showModel);
    session.whenChanged(ViewPart::Animation, this, &AnimationPanel::showAnimation);
    session.whenChanged(ViewPart::Scene, this, &AnimationPanel::stop);
}

template <class Change> void AnimationPanel::edit(Change change)
{
    Animation animation = workbench_.session().view().animation;
    change(animation);
    workbench_.session().setAnimation(animation);
}

void AnimationPanel::showModel()
{
    setEnabled(workbench_.session().model() != nullptr);
    showAnimation();
}

void AnimationPanel::showAnimation()
{
    stop();
    const Animation& animation = workbench_.session().view().animation;
    kind_->setCurrentIndex(static_cast<int>(animation.kind));
    pages_->setCurrentIndex(static_cast<int>(animation.kind));
    axis_->setCurrentIndex(static_cast<int>(animation.turntable.axis));
    showNumber(*degrees_, animation.turntable.degrees);
    showNumber(*frames_, animation.turntable.frames);
    showNumber(*rate_, static_cast<int>(std::lround(animation.framesPerSecond)));
    const int count = frameCount(animation);
    position_->setRange(0, std::max(0, count - 1));
    for (QWidget* widget : std::initializer_list<QWidget*>{play_, position_, write_})
        widget->setEnabled(count > 0);
    summary_->setText(
        count == 0 ? tr("Add at least two views.")
                   : tr("%1 frames, %2")
                         .arg(countText(static_cast<std::uint64_t>(count)), durationText(durationOf(animation))));
}

void AnimationPanel::play()
{
    if (viewport_.previewing())
        return stop();
    clock_.start();
    playing_.start();
    showFrame(0);
}

/// By the clock: where pictures take longer some frames are left out.
void AnimationPanel::playOn()
{
    const double seconds = static_cast<double>(clock_.elapsed()) / 1000;
    const double rate = workbench_.session().view().animation.framesPerSecond;
    const int frame = static_cast<int>(seconds * rate);
    if (frame > position_->maximum())
        return stop();
    position_->setValue(frame);
}

void AnimationPanel::showFrame(int frame)
{
    const Animation& animation = workbench_.session().view().animation;
    if (!workbench_.session().model() || frameCount(animation) == 0)
        return;
    const ViewValue shown = viewAtFrame(workbench_.session().view(), frame);
    if (animation.kind == Animation::Kind::KeyFrames)
        workbench_.scenes().previewView(shown);
    viewport_.setPreview(shown.camera);
    play_->setText(tr("Stop"));
}

void AnimationPanel::stop()
{
    playing_.stop();
    play_->setText(tr("Play"));
    viewport_.setPreview(std::nullopt);
    workbench_.scenes().previewView(std::nullopt);
    const QSignalBlocker blocker(position_);
    position_->setValue(0);
}

} // namespace tetra
