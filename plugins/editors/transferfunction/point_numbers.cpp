// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/point_numbers.h"

#include "plugins/widgets/colour_button.h"
#include "plugins/widgets/curves/whole_function.h"
#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/number_text.h"
#include "plugins/widgets/value_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>

namespace tetra {
namespace {

/// Unit distances that are offered, in diagonals of the domain.
constexpr double leastUnit = 1e-4;
constexpr double largestUnit = 10;

void showNumber(ValueBox& box, double value)
{
    const QSignalBlocker blocker(box);
    box.setValue(value);
}

} // namespace

PointNumbers::PointNumbers(EditorState& state, QWidget* parent)
    : QWidget(parent), state_(state), value_(new ValueBox), opacity_(new ValueBox), colour_(new ColourButton),
      unitDistance_(new ValueBox), lowerRow_(new QHBoxLayout)
{
    nameControls();
    layOut();
    connectControls();
}

void PointNumbers::nameControls()
{
    value_->setObjectName("transfer.value");
    value_->setAccessibleName(tr("Value"));
    value_->setToolTip(tr("Value of the selection, in data units; selected points move together"));
    opacity_->setObjectName("transfer.opacity");
    opacity_->setAccessibleName(tr("Opacity"));
    opacity_->setToolTip(tr("Opacity of the selected points: percentage of light absorbed per unit distance"));
    opacity_->setValueRange(0, 100);
    opacity_->setDecimals(2);
    opacity_->setSuffix(tr(" %"));
    colour_->setObjectName("transfer.colour");
    colour_->setToolTip(tr("Colour of the selection"));
    unitDistance_->setObjectName("transfer.unitDistance");
    unitDistance_->setAccessibleName(tr("Unit distance"));
    unitDistance_->setToolTip(tr(
        "The thickness of a layer to which the opacities apply, in data units: a smaller one makes everything denser"));
    for (ValueBox* box : {value_, opacity_, unitDistance_})
        new GestureWatcher(box, state_.host());
}

void PointNumbers::layOut()
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    const auto label = [](const QString& text, QWidget* buddy) {
        auto* made = new QLabel(text);
        made->setBuddy(buddy);
        return made;
    };
    grid->addWidget(label(tr("Val&ue"), value_), 0, 0);
    grid->addWidget(value_, 0, 1);
    grid->addWidget(label(tr("O&pacity"), opacity_), 0, 2);
    grid->addWidget(opacity_, 0, 3);
    grid->addWidget(colour_, 0, 4);
    lowerRow_->setSpacing(5);
    lowerRow_->addWidget(label(tr("U&nit distance"), unitDistance_));
    lowerRow_->addWidget(unitDistance_, 1);
    grid->addLayout(lowerRow_, 1, 0, 1, 5);
    grid->setVerticalSpacing(4);
    grid->setHorizontalSpacing(5);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
}

void PointNumbers::connectControls()
{
    connect(value_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        state_.setCurrentValue(value);
        showSelection(); // also when a neighbour stopped it
    });
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, [this](double percent) { setOpacity(percent); });
    connect(colour_, &ColourButton::colourChosen, this, &PointNumbers::setColour);
    connect(unitDistance_, &QDoubleSpinBox::valueChanged, this,
            [this](double distance) { state_.setFunction(withUnitDistance(state_.function(), distance)); });
}

void PointNumbers::setOpacity(double percent)
{
    if (state_.current().kind == EditorItem::Kind::Isovalue) {
        Isovalue isovalue = state_.host().isovalues()[state_.current().index];
        isovalue.opacity = static_cast<float>(percent / 100);
        return state_.host().setIsovalue(state_.current().index, isovalue);
    }
    state_.apply(withOpacity(state_.joinedFunction(), state_.selection(), percent / 100));
}

void PointNumbers::setColour(const QColor& colour)
{
    const std::array channels{static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                              static_cast<float>(colour.blueF())};
    if (state_.current().kind == EditorItem::Kind::Isovalue) {
        Isovalue isovalue = state_.host().isovalues()[state_.current().index];
        isovalue.red = channels[0];
        isovalue.green = channels[1];
        isovalue.blue = channels[2];
        return state_.host().setIsovalue(state_.current().index, isovalue);
    }
    state_.apply(withColour(state_.joinedFunction(), state_.selection(), channels));
}

void PointNumbers::askForColour()
{
    if (colour_->isEnabled())
        colour_->chooseOther();
}

void PointNumbers::showModel()
{
    if (!state_.host().hasModel())
        return;
    const double diagonal = state_.host().diagonal() > 0 ? state_.host().diagonal() : 1;
    const QSignalBlocker blocker(unitDistance_);
    unitDistance_->setValueRange(leastUnit * diagonal, largestUnit * diagonal);
    unitDistance_->setDecimals(std::max(unitDistance_->decimals(), decimalsFor(leastUnit * diagonal)));
    unitDistance_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
}

void PointNumbers::showSelection()
{
    const EditorItem current = state_.current();
    const auto value = state_.valueOf(current);
    const bool hasColour = current.kind == EditorItem::Kind::Point || current.kind == EditorItem::Kind::Isovalue;
    value_->setEnabled(value.has_value());
    opacity_->setEnabled(hasColour);
    colour_->setEnabled(hasColour);
    const QSignalBlocker blocker(value_);
    value_->setOfLogarithms(state_.ofLogarithms());
    value_->setValueRange(state_.limits().least, state_.limits().largest);
    if (value)
        showNumber(*value_, *value);
    if (!hasColour)
        colour_->setColour(palette().color(QPalette::Button));
    if (current.kind == EditorItem::Kind::Point) {
        const TransferPoint& point = state_.joinedFunction().points[current.index];
        showNumber(*opacity_, 100.0 * point.opacity);
        colour_->setColour(QColor::fromRgbF(point.colour[0], point.colour[1], point.colour[2]));
    } else if (current.kind == EditorItem::Kind::Isovalue) {
        const Isovalue& isovalue = state_.host().isovalues()[current.index];
        showNumber(*opacity_, 100.0 * isovalue.opacity);
        colour_->setColour(QColor::fromRgbF(isovalue.red, isovalue.green, isovalue.blue));
    }
    showNumber(*unitDistance_, state_.function().unitDistance);
}

} // namespace tetra
