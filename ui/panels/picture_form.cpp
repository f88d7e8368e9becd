// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/picture_form.h"

#include "core/render/scene_checks.h"
#include "ui/panels/annotation_rows.h"

#include <tan/render.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

enum Preset { AsSeen, Twice, Hd, FullHd, FourK, Custom };
constexpr double centimetresPerInch = 2.54;
constexpr int usualDpi = 150;

QSize sizeOf(int preset, const QSize& view, const QSize& custom)
{
    switch (preset) {
    case AsSeen: return view;
    case Twice: return 2 * view;
    case Hd: return {1280, 720};
    case FullHd: return {1920, 1080};
    case FourK: return {3840, 2160};
    default: return custom;
    }
}

QSpinBox* makeBox(const QString& name, int most, const QString& suffix, const QString& title, const QString& toolTip)
{
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setRange(1, most);
    box->setSuffix(suffix);
    box->setAccessibleName(title);
    box->setToolTip(toolTip);
    return box;
}

QDoubleSpinBox* makeLengthBox(const QString& name, const QString& title, const QString& toolTip)
{
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(1);
    box->setRange(0.1, centimetresPerInch * largestPictureSide);
    box->setSuffix(PictureForm::tr(" cm"));
    box->setAccessibleName(title);
    box->setToolTip(toolTip);
    box->setKeyboardTracking(false); // half of a number is another size
    return box;
}

/// A row of several widgets, the first of which its label leads to.
void addRow(QFormLayout& form, const QString& text, QWidget& first, QLayout& row)
{
    auto* label = new QLabel(text);
    label->setBuddy(&first);
    form.addRow(label, &row);
}

} // namespace

PictureForm::PictureForm(const QString& name, PictureUse use, QWidget* parent)
    : QWidget(parent), preset_(new QComboBox),
      width_(makeBox(name + ".width", largestPictureSide, tr(" px"), tr("Width"), tr("Width in pixels"))),
      height_(makeBox(name + ".height", largestPictureSide, tr(" px"), tr("Height"), tr("Height in pixels"))),
      keepProportions_(new QCheckBox(tr("&Keep proportions"))),
      transparent_(new QCheckBox(tr("Trans&parent background")))
{
    setObjectName(name);
    auto* form = new QFormLayout(this);
    form->setContentsMargins({});
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addSize(*form);
    if (use == PictureUse::Print)
        addPrint(*form);
    addBackground(*form);
    addAnnotations(*form);
    const QSettings settings;
    preset_->setCurrentIndex(settings.value(name + "/preset", AsSeen).toInt());
    width_->setValue(settings.value(name + "/width", view_.width()).toInt());
    height_->setValue(settings.value(name + "/height", view_.height()).toInt());
    keepProportions_->setChecked(settings.value(name + "/keepProportions", true).toBool());
    transparent_->setChecked(settings.value(name + "/transparent", false).toBool());
    connect(preset_, &QComboBox::activated, this, &PictureForm::choosePreset);
    for (QSpinBox* box : {width_, height_})
        connect(box, &QSpinBox::valueChanged, this, [this, box] {
            keepsPrintSize_ = false;
            choosePixels(*box);
            showPrintSize();
        });
    connect(keepProportions_, &QCheckBox::clicked, this, [this] { keepProportions(*width_); });
    choosePreset();
}

void PictureForm::addSize(QFormLayout& form)
{
    const QString name = objectName();
    preset_->setObjectName(name + ".preset");
    preset_->addItems(
        {tr("As on screen"), tr("Twice the screen size"), tr("HD"), tr("Full HD"), tr("4K"), tr("Custom")});
    preset_->setToolTip(tr("Annotations and lines take up the same share of the picture as of the view"));
    form.addRow(tr("Si&ze"), preset_);
    auto* pixels = new QHBoxLayout;
    pixels->addWidget(width_, 1);
    pixels->addWidget(new QLabel(QString(QChar(0xd7))));
    pixels->addWidget(height_, 1);
    addRow(form, tr("Pixe&ls"), *width_, *pixels);
    keepProportions_->setObjectName(name + ".keepProportions");
    keepProportions_->setToolTip(tr("Width and height change together, so that nothing is added or cut off"));
    form.addRow(QString(), keepProportions_);
}

void PictureForm::addPrint(QFormLayout& form)
{
    const QString name = objectName();
    printWidth_ = makeLengthBox(name + ".printWidth", tr("Printed width"),
                                tr("Width of the print in centimetres; the pixels follow from it and the resolution"));
    printHeight_ =
        makeLengthBox(name + ".printHeight", tr("Printed height"),
                      tr("Height of the print in centimetres; the pixels follow from it and the resolution"));
    auto* print = new QHBoxLayout;
    print->addWidget(printWidth_, 1);
    print->addWidget(new QLabel(QString(QChar(0xd7))));
    print->addWidget(printHeight_, 1);
    addRow(form, tr("Pri&nt size"), *printWidth_, *print);
    for (QDoubleSpinBox* box : {printWidth_, printHeight_})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, box] { choosePrintSize(*box); });
    dpi_ = makeBox(name + ".dpi", 2400, tr(" dpi"), tr("Resolution"),
                   tr("Print resolution in pixels per inch; the number of pixels changes only after a size in "
                      "centimetres was entered"));
    dpi_->setValue(QSettings().value(name + "/dpi", usualDpi).toInt());
    dpi_->setKeyboardTracking(false); // half of a number is another resolution
    connect(dpi_, &QSpinBox::valueChanged, this, &PictureForm::chooseResolution);
    form.addRow(tr("Print &resolution"), dpi_);
}

void PictureForm::addBackground(QFormLayout& form)
{
    transparent_->setObjectName(objectName() + ".transparent");
    transparent_->setToolTip(tr("Leave out the background, to place the picture over something else"));
    form.addRow(tr("Background"), transparent_);
}

void PictureForm::addAnnotations(QFormLayout& form)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const auto kind = static_cast<AnnotationKind>(i);
        shown_[i] = new QCheckBox(annotationText(kind, true));
        shown_[i]->setObjectName(objectName() + ".annotation." + annotationNames[i]);
        shown_[i]->setToolTip(annotationExplanation(kind));
        form.addRow(i == 0 ? tr("Annotations") : QString(), shown_[i]);
    }
}

void PictureForm::setView(QSize pixels, const AnnotationState& annotations)
{
    view_ = pixels;
    annotations_ = annotations;
    for (std::size_t i = 0; i < annotationCount; ++i)
        shown_[i]->setChecked(annotations.places[i].shown);
    choosePreset();
}

PictureSettings PictureForm::settings() const
{
    PictureSettings settings{
        {width_->value(), height_->value()}, dpi_ ? dpi_->value() : 0, transparent_->isChecked(), annotations_};
    for (std::size_t i = 0; i < annotationCount; ++i)
        settings.annotations.places[i].shown = shown_[i]->isChecked();
    return settings;
}

void PictureForm::remember() const
{
    QSettings settings;
    settings.setValue(objectName() + "/preset", preset_->currentIndex());
    settings.setValue(objectName() + "/width", width_->value());
    settings.setValue(objectName() + "/height", height_->value());
    settings.setValue(objectName() + "/keepProportions", keepProportions_->isChecked());
    if (dpi_)
        settings.setValue(objectName() + "/dpi", dpi_->value());
    settings.setValue(objectName() + "/transparent", transparent_->isChecked());
}

void PictureForm::choosePreset()
{
    const QSize size = sizeOf(preset_->currentIndex(), view_, {width_->value(), height_->value()});
    {
        const QSignalBlocker widthBlocker(width_), heightBlocker(height_);
        width_->setValue(size.width());
        height_->setValue(size.height());
    }
    widthPerHeight_ = static_cast<double>(width_->value()) / height_->value();
    keepsPrintSize_ = false;
    showPrintSize();
    emit changed();
}

void PictureForm::choosePixels(QSpinBox& edited)
{
    preset_->setCurrentIndex(Custom);
    keepProportions(edited);
    emit changed();
}

/// The other side follows the one that was edited, as far as pictures can be that large. Sides that were let go have
/// the proportions to be kept from then on.
void PictureForm::keepProportions(QSpinBox& edited)
{
    if (!keepProportions_->isChecked()) {
        widthPerHeight_ = static_cast<double>(width_->value()) / height_->value();
        return;
    }
    const double largestWidth = std::min<double>(largestPictureSide, largestPictureSide * widthPerHeight_);
    const double wanted = &edited == width_ ? width_->value() : height_->value() * widthPerHeight_;
    const double width = std::min(wanted, largestWidth);
    const QSignalBlocker widthBlocker(width_), heightBlocker(height_);
    if (&edited != width_ || width < wanted)
        width_->setValue(static_cast<int>(std::lround(width)));
    if (&edited == width_ || width < wanted)
        height_->setValue(static_cast<int>(std::lround(width / widthPerHeight_)));
}

void PictureForm::showPrintSize()
{
    if (!dpi_)
        return;
    for (const auto& [box, pixels] : {std::pair(printWidth_, width_), std::pair(printHeight_, height_)}) {
        const QSignalBlocker blocker(box);
        box->setValue(pixels->value() * centimetresPerInch / dpi_->value());
    }
}

void PictureForm::choosePrintSize(QDoubleSpinBox& edited)
{
    QSpinBox& pixels = &edited == printWidth_ ? *width_ : *height_;
    {
        const QSignalBlocker blocker(&pixels);
        pixels.setValue(static_cast<int>(std::lround(edited.value() / centimetresPerInch * dpi_->value())));
    }
    choosePixels(pixels);
    keepsPrintSize_ = true;
    showPrintSize();
}

void PictureForm::chooseResolution()
{
    if (keepsPrintSize_)
        choosePrintSize(*printWidth_);
    else
        showPrintSize();
}

} // namespace tetra
