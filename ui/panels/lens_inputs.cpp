// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/lens_inputs.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/icons.h"
#include "plugins/widgets/value_box.h"
#include "ui/panels/accuracy_inputs.h"
#include "ui/widgets/checked_button.h"
#include "ui/widgets/value_slider.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace tetra {

LensInputs::LensInputs(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), settings_(new QWidget),
      magnification_(new ValueSlider("lens.magnification", session)), radius_(new ValueSlider("lens.radius", session)),
      error_(new AccuracySlider), errorBox_(new AccuracyBox)
{
    setObjectName("lens");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(new QLabel(tr("Lens over the picture")));
    layout->addLayout(makeShapes());
    makeSettings();
    layout->addWidget(settings_);
    connect(&session_, &Session::modelChanged, this, &LensInputs::show);
    session_.whenChanged(ViewPart::Lens, this, &LensInputs::show);
    show();
}

template <class Change> void LensInputs::edit(Change change)
{
    LensState changed = session_.view().lens;
    change(changed);
    session_.setLens(changed);
    show();
}

QLayout* LensInputs::makeShapes()
{
    struct Entry {
        const char* name;
        QString text;
        QString toolTip;
        std::optional<Glyph> glyph;
    };
    const std::array<Entry, 3> entries{{
        {"lens.none", tr("None", "no lens"), tr("No lens"), std::nullopt},
        {"lens.circle", tr("Circle"),
         tr("A round lens with its own error (L). Drag it; turn the wheel over it to change the magnification."),
         Glyph::Lens},
        {"lens.square", tr("Square"), tr("A square lens, with its own error"), std::nullopt},
    }};
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        auto* button = new QToolButton;
        button->setObjectName(entries[i].name);
        button->setText(entries[i].text);
        button->setToolTip(entries[i].toolTip);
        if (entries[i].glyph)
            button->setIcon(glyphIcon(*entries[i].glyph));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this,
                [this, i] { edit([i](LensState& changed) { changed.shape = static_cast<LensState::Shape>(i); }); });
        row->addWidget(button);
        shapes_[i] = button;
    }
    return row;
}

void LensInputs::makeSettings()
{
    magnification_->setTexts(tr("Magnification"), tr("How much larger the lens shows what is under its centre"));
    magnification_->setRange(leastMagnification, largestMagnification);
    radius_->setTexts(tr("Size of the lens"),
                      tr("Half the width of the lens, in percent of the picture's shorter side"));
    radius_->setRange(100 * leastLensRadius, 100 * largestLensRadius);
    error_->setObjectName("lens.error.slider");
    errorBox_->setObjectName("lens.error.box");
    for (QWidget* input : std::initializer_list<QWidget*>{error_, errorBox_}) {
        input->setAccessibleName(tr("Error in the lens"));
        input->setToolTip(tr("Error of the mesh in the lens, in percent of the value range; it is never coarser than "
                             "the mesh of the picture"));
        new GestureWatcher(input, session_);
    }
    auto* errors = new QWidget;
    auto* row = new QHBoxLayout(errors);
    row->setContentsMargins({});
    row->addWidget(error_, 1);
    row->addWidget(errorBox_);
    errors->setFocusProxy(errorBox_);
    auto* grid = new QGridLayout(settings_);
    grid->setContentsMargins({});
    grid->setColumnStretch(1, 1);
    int line = 0;
    for (const auto& [text, input] : std::initializer_list<std::pair<QString, QWidget*>>{
             {tr("Magnificati&on"), magnification_}, {tr("Si&ze"), radius_}, {tr("E&rror inside"), errors}}) {
        auto* label = new QLabel(text);
        label->setBuddy(input);
        grid->addWidget(label, line, 0);
        grid->addWidget(input, line++, 1);
    }
    connect(magnification_, &ValueSlider::edited, this,
            [this](double value) { edit([value](LensState& changed) { changed.magnification = value; }); });
    connect(radius_, &ValueSlider::edited, this,
            [this](double value) { edit([value](LensState& changed) { changed.radius = value / 100; }); });
    const auto choose = [this](double percent) { edit([percent](LensState& changed) { changed.error = percent; }); };
    connect(error_, &AccuracySlider::chosen, this, choose);
    connect(errorBox_, &AccuracyBox::chosen, this, choose);
    const std::initializer_list<QWidget*> boxes{magnification_->box(), radius_->box(), errorBox_};
    int width = 0;
    for (const QWidget* box : boxes)
        width = std::max(width, box->sizeHint().width());
    for (QWidget* box : boxes)
        box->setFixedWidth(width);
}

void LensInputs::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        show();
}

void LensInputs::show()
{
    const LensState& lens = session_.view().lens;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        showChecked(*shapes_[i], i == static_cast<std::size_t>(lens.shape));
    settings_->setVisible(lens.isOn());
    magnification_->setValue(lens.magnification);
    radius_->setValue(100 * lens.radius);
    error_->setAccuracy(lens.error);
    errorBox_->setAccuracy(lens.error);
}

} // namespace tetra
