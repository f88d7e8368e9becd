// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/annotation_rows.h"

#include "core/picture/annotations/annotation_content.h"
#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/value_box.h"
#include "ui/session/annotation_language.h"
#include "ui/session/logarithm_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

class AnnotationRowTexts {
    Q_DECLARE_TR_FUNCTIONS(Annotations)
};

constexpr int indent = 20; ///< of what belongs to the annotation above
constexpr std::array formats{&AnnotationState::numbers, &AnnotationState::lengths};
constexpr std::array texts{&AnnotationState::title, &AnnotationState::quantity, &AnnotationState::unit};

QWidget* indented(QWidget& widget)
{
    auto* around = new QWidget;
    auto* layout = new QHBoxLayout(around);
    layout->setContentsMargins(indent, 0, 0, 0);
    layout->addWidget(&widget);
    return around;
}

} // namespace

QString annotationText(AnnotationKind kind, bool mnemonic)
{
    QString text;
    switch (kind) {
    case AnnotationKind::ColourBar: text = AnnotationRowTexts::tr("Colour &bar"); break;
    case AnnotationKind::Axes: text = AnnotationRowTexts::tr("A&xes"); break;
    case AnnotationKind::ScaleBar: text = AnnotationRowTexts::tr("&Scale bar"); break;
    case AnnotationKind::Title: text = AnnotationRowTexts::tr("&Title"); break;
    case AnnotationKind::Accuracy: text = AnnotationRowTexts::tr("A&ccuracy"); break;
    case AnnotationKind::BoxAxes: text = AnnotationRowTexts::tr("Axes with &numbers"); break;
    }
    return mnemonic ? text : text.remove('&');
}

QString annotationExplanation(AnnotationKind kind)
{
    switch (kind) {
    case AnnotationKind::ColourBar:
        return AnnotationRowTexts::tr(
            "Values and their colours, in data units; on the right their opacity, with marks at the isovalues");
    case AnnotationKind::Axes: return AnnotationRowTexts::tr("The directions of x, y and z");
    case AnnotationKind::ScaleBar:
        return AnnotationRowTexts::tr(
            "A length in data units; in perspective it applies at the distance of the target");
    case AnnotationKind::Title: return AnnotationRowTexts::tr("The name of the model, or a text of your own");
    case AnnotationKind::Accuracy:
        return AnnotationRowTexts::tr("The error bound of the displayed mesh, in % of the value range");
    case AnnotationKind::BoxAxes:
        return AnnotationRowTexts::tr("Coordinates along the edges of the box around the data, in data units");
    }
    return {};
}

AnnotationRows::AnnotationRows(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), fixed_(new QCheckBox(tr("Fixed ends"))), least_(new ValueBox),
      largest_(new ValueBox), textSize_(new QSpinBox), boldText_(new QCheckBox(tr("Bold")))
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const auto kind = static_cast<AnnotationKind>(i);
        const QString name = QString("view.annotation.") + annotationNames[i];
        shown_[i] = new QCheckBox(annotationText(kind));
        shown_[i]->setObjectName(name);
        shown_[i]->setToolTip(annotationExplanation(kind));
        const int row = grid->rowCount();
        grid->addWidget(shown_[i], row, 0);
        if (isInCorner(kind))
            grid->addWidget(makeCorner(i), row, 1);
        if (kind == AnnotationKind::ColourBar) {
            grid->addWidget(makeBarEnds(), row + 1, 0, 1, 2);
            grid->addWidget(makeBarTexts(), row + 2, 0, 1, 2);
        }
        if (kind == AnnotationKind::Title)
            grid->addWidget(indented(*makeText(0, "title", tr("Text of the title"),
                                               tr("The title; if empty, the name of the model"))),
                            row + 1, 0, 1, 2);
        connect(shown_[i], &QCheckBox::clicked, this, [this, i] { edit(i); });
    }
    grid->addWidget(makeTextLook(), grid->rowCount(), 0, 1, 2);
    const auto follow = [this] { show(session_.view().annotations); };
    connect(&session_, &Session::modelChanged, this, follow);
    session_.whenChanged(ViewPart::Annotations, this, follow);
    show(session_.view().annotations);
}

QComboBox* AnnotationRows::makeCorner(std::size_t index)
{
    const auto kind = static_cast<AnnotationKind>(index);
    auto* corner = new QComboBox;
    corner->setObjectName(QString("view.annotation.") + annotationNames[index] + ".corner");
    corner->addItems({tr("Top left"), tr("Top right"), tr("Bottom left"), tr("Bottom right")});
    corner->setToolTip(tr("Corner of the picture"));
    corner->setAccessibleName(tr("%1: corner").arg(annotationText(kind)));
    connect(corner, &QComboBox::activated, this, [this, index] { edit(index); });
    corners_[index] = corner;
    return corner;
}

void AnnotationRows::show(const AnnotationState& state)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        shown_[i]->setChecked(state.places[i].shown);
        if (corners_[i] == nullptr)
            continue;
        corners_[i]->setCurrentIndex(static_cast<int>(state.places[i].corner));
        corners_[i]->setEnabled(state.places[i].shown);
    }
    showBarEnds(state);
    showTexts(state);
    showNumbers(state);
    const QSignalBlocker blocker(textSize_);
    textSize_->setValue(static_cast<int>(std::lround(state.textSize)));
    boldText_->setChecked(state.boldText);
}

QWidget* AnnotationRows::makeBarEnds()
{
    fixed_->setObjectName("view.barEnds.fixed");
    fixed_->setToolTip(tr("The colour bar covers a chosen range, so that several pictures can share it; otherwise it "
                          "covers all values of the data"));
    least_->setObjectName("view.barEnds.least");
    least_->setAccessibleName(tr("Colour bar: smaller end"));
    least_->setToolTip(tr("Value at the lower end of the colour bar"));
    largest_->setObjectName("view.barEnds.largest");
    largest_->setAccessibleName(tr("Colour bar: larger end"));
    largest_->setToolTip(tr("Value at the upper end of the colour bar"));
    auto* ends = new QWidget;
    auto* row = new QHBoxLayout(ends);
    row->setContentsMargins(indent, 0, 0, 0);
    row->addWidget(fixed_);
    row->addWidget(least_, 1);
    row->addWidget(largest_, 1);
    connect(fixed_, &QCheckBox::clicked, this, [this](bool on) {
        const ValueRange range = session_.range();
        setBarEnds(on ? std::optional<BarEnds>({range.minimum, range.maximum}) : std::nullopt);
    });
    for (const auto& [box, end] : {std::pair(least_, &BarEnds::least), std::pair(largest_, &BarEnds::largest)}) {
        new GestureWatcher(box, session_);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, end = end](double value) { moveEnd(end, value); });
    }
    return ends;
}

QWidget* AnnotationRows::makeBarTexts()
{
    auto* around = new QWidget;
    auto* form = new QFormLayout(around);
    form->setContentsMargins(indent, 0, 0, 0);
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("Quantity"), makeText(1, "quantity", tr("Colour bar: quantity"),
                                          tr("What the colour bar shows, such as density; if empty, the name of the "
                                             "values in the data")));
    form->addRow(tr("Unit"), makeText(2, "unit", tr("Colour bar: unit"),
                                      tr("The unit of the values, such as HU or K, written in brackets behind the "
                                         "quantity")));
    form->addRow(tr("Numbers"), makeNumbers(0));
    return around;
}

/// A line for one of the texts, which counts when it is finished.
QLineEdit* AnnotationRows::makeText(std::size_t index, const QString& name, const QString& title,
                                    const QString& toolTip)
{
    constexpr int longest = 200;
    auto* line = new QLineEdit;
    line->setObjectName("view.annotationText." + name);
    line->setAccessibleName(title);
    line->setToolTip(toolTip);
    line->setMaxLength(longest);
    line->setClearButtonEnabled(true);
    connect(line, &QLineEdit::editingFinished, this, [this, line, text = texts[index]] {
        AnnotationState state = session_.view().annotations;
        state.*text = line->text().toStdString();
        session_.setAnnotations(state);
    });
    texts_[index] = line;
    return line;
}

/// How the numbers of the colour bar are written, or those of the scale bar and of the axes with numbers.
QWidget* AnnotationRows::makeNumbers(std::size_t index)
{
    const bool ofBar = index == 0;
    const QString name = ofBar ? "view.numbers" : "view.lengths";
    auto* style = new QComboBox;
    style->setObjectName(name + ".style");
    style->addItems({tr("Automatic"), tr("Plain"), tr("Powers of ten")});
    style->setAccessibleName(ofBar ? tr("Colour bar: format of the numbers") : tr("Lengths: format of the numbers"));
    style->setToolTip(ofBar ? tr("How the numbers at the colour bar are written: as short as tells them apart, or with "
                                 "a chosen number of decimals, plain or in powers of ten")
                            : tr("How the numbers of the scale bar and of the axes are written: as short as tells them "
                                 "apart, or with a chosen number of decimals, plain or in powers of ten"));
    auto* decimals = new QSpinBox;
    decimals->setObjectName(name + ".decimals");
    decimals->setRange(0, mostDecimals);
    decimals->setAccessibleName(ofBar ? tr("Colour bar: decimals") : tr("Lengths: decimals"));
    decimals->setToolTip(tr("Number of digits behind the decimal point"));
    auto* numbers = new QWidget;
    auto* row = new QHBoxLayout(numbers);
    row->setContentsMargins({});
    row->addWidget(style, 1);
    row->addWidget(decimals);
    connect(style, &QComboBox::activated, this, [this, index] { editNumbers(index); });
    new GestureWatcher(decimals, session_);
    connect(decimals, &QSpinBox::valueChanged, this, [this, index] { editNumbers(index); });
    numberStyles_[index] = style;
    decimals_[index] = decimals;
    return numbers;
}

void AnnotationRows::editNumbers(std::size_t index)
{
    AnnotationState state = session_.view().annotations;
    state.*formats[index] = {static_cast<NumberFormat::Style>(numberStyles_[index]->currentIndex()),
                             decimals_[index]->value()};
    session_.setAnnotations(state);
}

void AnnotationRows::showNumbers(const AnnotationState& state)
{
    const std::array<bool, 2> isUsed{state[AnnotationKind::ColourBar].shown,
                                     state[AnnotationKind::ScaleBar].shown || state[AnnotationKind::BoxAxes].shown};
    for (std::size_t i = 0; i < formats.size(); ++i) {
        const NumberFormat& format = state.*formats[i];
        const QSignalBlocker blocker(decimals_[i]);
        numberStyles_[i]->setCurrentIndex(static_cast<int>(format.style));
        numberStyles_[i]->setEnabled(isUsed[i]);
        decimals_[i]->setValue(format.decimals);
        decimals_[i]->setEnabled(isUsed[i] && format.style != NumberFormat::Style::Automatic);
    }
}

/// What is common to all annotations.
QWidget* AnnotationRows::makeTextLook()
{
    textSize_->setObjectName("view.textSize");
    textSize_->setRange(static_cast<int>(smallestTextSize), static_cast<int>(largestTextSize));
    textSize_->setAccessibleName(tr("Annotations: size of the text"));
    textSize_->setToolTip(tr("How large the texts of all annotations are; bars, arrows and lines grow with them"));
    boldText_->setObjectName("view.boldText");
    boldText_->setToolTip(tr("Write all annotations in bold letters"));
    auto* size = new QWidget;
    auto* row = new QHBoxLayout(size);
    row->setContentsMargins({});
    row->addWidget(textSize_, 1);
    row->addWidget(boldText_);
    auto* around = new QWidget;
    auto* form = new QFormLayout(around);
    form->setContentsMargins({});
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("Lengths"), makeNumbers(1));
    form->addRow(tr("Text size"), size);
    new GestureWatcher(textSize_, session_);
    connect(textSize_, &QSpinBox::valueChanged, this, &AnnotationRows::editTextLook);
    connect(boldText_, &QCheckBox::clicked, this, &AnnotationRows::editTextLook);
    return around;
}

void AnnotationRows::editTextLook()
{
    AnnotationState state = session_.view().annotations;
    state.textSize = textSize_->value();
    state.boldText = boldText_->isChecked();
    session_.setAnnotations(state);
}

/// What the data say stands in the empty lines.
void AnnotationRows::showTexts(const AnnotationState& state)
{
    const auto& model = session_.model();
    const std::array<QString, 3> usual{
        model ? QString::fromStdString(usualTitle(*model)) : QString(),
        model ? QString::fromStdString(usualQuantity(model->description(), annotationLanguage())) : QString(),
        model ? QString::fromStdString(usualUnit(model->description())) : QString()};
    const bool hasBar = state[AnnotationKind::ColourBar].shown;
    for (std::size_t i = 0; i < texts_.size(); ++i) {
        if (const auto text = QString::fromStdString(state.*texts[i]); texts_[i]->text() != text)
            texts_[i]->setText(text);
        texts_[i]->setPlaceholderText(usual[i]);
        texts_[i]->setEnabled(i == 0 ? state[AnnotationKind::Title].shown : hasBar);
    }
}

/// Boxes step and round as the data's values ask for, and take what lies far beside them: a bar may be that of many
/// models.
void AnnotationRows::showBarEnds(const AnnotationState& state)
{
    const ValueRange range = session_.range();
    const BarEnds shown = state.barEnds.value_or(BarEnds{range.minimum, range.maximum});
    const bool isUsed = state[AnnotationKind::ColourBar].shown && range.extent() > 0;
    fixed_->setEnabled(isUsed);
    fixed_->setChecked(state.barEnds.has_value());
    constexpr double extentsBeside = 1000;
    for (const auto& [box, value] : {std::pair(least_, shown.least), std::pair(largest_, shown.largest)}) {
        const QSignalBlocker blocker(box);
        box->setEnabled(isUsed && state.barEnds);
        box->setOfLogarithms(session_.model() && logarithmsOf(session_.model()->description()));
        box->setValueRange(range.minimum, range.maximum);
        box->setRange(std::min(shown.least, range.minimum - extentsBeside * range.extent()),
                      std::max(shown.largest, range.maximum + extentsBeside * range.extent()));
        box->setValue(value);
    }
}

void AnnotationRows::setBarEnds(const std::optional<BarEnds>& ends)
{
    AnnotationState state = session_.view().annotations;
    state.barEnds = ends;
    session_.setAnnotations(state);
}

void AnnotationRows::moveEnd(double BarEnds::*end, double value)
{
    std::optional<BarEnds> ends = session_.view().annotations.barEnds;
    if (!ends)
        return;
    const double extent = ends->largest - ends->least;
    ends.value().*end = value;
    if (!(ends->least < ends->largest) && end == &BarEnds::least)
        ends->largest = ends->least + extent;
    else if (!(ends->least < ends->largest))
        ends->least = ends->largest - extent;
    setBarEnds(ends);
}

void AnnotationRows::edit(std::size_t index)
{
    AnnotationState state = session_.view().annotations;
    state.places[index].shown = shown_[index]->isChecked();
    if (corners_[index] != nullptr)
        state.places[index].corner = static_cast<Corner>(corners_[index]->currentIndex());
    session_.setAnnotations(state);
}

} // namespace tetra
