// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/picture/annotations/annotation_parts.h"
#include "core/picture/annotations/bar_axis.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double barWidth = 20;
constexpr double labelGap = 9;       ///< from the bar to its labels, with the tick between
constexpr double markWidth = 9;      ///< left of the bar, for the isovalues' marks
constexpr double widestField = 150;  ///< the name of the values
constexpr double widestTyped = 300;  ///< if somebody has typed it ...
constexpr double typedShare = 0.45;  ///< ... and of the picture's width
constexpr double linesPerTick = 2.2; ///< heights of a line from one tick to the next, or more
constexpr int mostTicks = 9;

std::vector<double> ticksFor(const BarAxis& axis, double height, const TextMeasure& measure)
{
    const int most = std::clamp(static_cast<int>(height / (linesPerTick * measure.height)), 2, mostTicks);
    return barTicks(axis, most);
}

/// Of all labels: the ticks' and the isovalues'.
double labelWidth(const AnnotationContent& content, const BarAxis& axis, double height, const TextMeasure& measure)
{
    const NumberSigns& signs = content.language.numbers;
    double widest = 0;
    const auto ticks = ticksFor(axis, height, measure);
    for (const std::string& text : barTickTexts(axis, ticks, signs, content.state.numbers))
        widest = std::max(widest, measure.width(text));
    if (content.isovalues && !content.transfer)
        for (const Isovalue& isovalue : *content.isovalues)
            if (axis.contains(isovalue.value))
                widest = std::max(
                    widest, measure.width(barValueText(axis, isovalue.value, ticks, signs, content.state.numbers)));
    return std::ceil(widest);
}

/// The name of the values with their unit, of which the name is cut where there is no room for both.
PlacedText barName(const AnnotationContent& content, double most, const TextMeasure& measure)
{
    const AnnotationState& state = content.state;
    const std::string name = state.quantity.empty() ? content.field : visibleText(state.quantity);
    const std::string of = state.unit.empty() ? content.unit : visibleText(state.unit);
    if (of.empty())
        return fittedText(name, most, measure);
    const std::string unit = (name.empty() ? "(" : " (") + of + ")";
    const double left = most - std::ceil(measure.width(unit));
    const std::string shown = name.empty() || measure.width(name + unit) <= most ? name
                              : left > 0                                         ? fittedText(name, left, measure).text
                                                                                 : std::string();
    return fittedText(shown + unit, most, measure);
}

double positionOf(double value, const BarAxis& axis, const Rectangle& bar)
{
    return bar.bottom() - std::clamp(axis.shareOf(value), 0.0, 1.0) * bar.height;
}

/// Gives marks their labels, in their order, but for those that would touch one that is there already.
class LabelColumn {
public:
    LabelColumn(const Rectangle& bar, const TextMeasure& measure) : left_(bar.right() + labelGap), measure_(measure) {}

    void label(AxisMark& mark, const std::string& text)
    {
        const Rectangle place{left_, mark.position - measure_.height / 2, measure_.width(text), measure_.height};
        if (std::ranges::any_of(taken_, [&](const Rectangle& other) { return other.intersects(place); }))
            return;
        taken_.push_back(place);
        mark.label = {text, place};
    }

private:
    double left_;
    const TextMeasure& measure_;
    std::vector<Rectangle> taken_;
};

} // namespace

Size colourBarSize(const AnnotationContent& content, const BarAxis& axis, double height, const Size& picture,
                   const TextMeasure& measure)
{
    const bool hasMarks = content.isovalues && !content.isovalues->empty();
    if (!(axis.ends.largest > axis.ends.least) || (!content.transfer && !hasMarks))
        return {};
    const double width = markWidth + barWidth + labelGap + labelWidth(content, axis, height, measure);
    const AnnotationState& state = content.state;
    const bool isTyped = !state.quantity.empty() || !state.unit.empty();
    const double most = isTyped ? std::clamp(typedShare * picture.width, widestField, widestTyped) : widestField;
    const double name = barName(content, most, measure).place.width;
    return {std::max(width, name), height};
}

ColourBarLayout layOutColourBar(const AnnotationContent& content, const BarAxis& axis, const Rectangle& place,
                                const TextMeasure& measure)
{
    ColourBarLayout layout;
    layout.axis = axis;
    layout.field = barName(content, place.width + 0.5, measure);
    layout.field.place.left = place.left;
    layout.field.place.top = place.top;
    // Half a line at both ends is for the labels there.
    const double half = std::ceil(measure.height / 2);
    const double above = layout.field.text.empty() ? half : std::round(1.8 * measure.height);
    layout.bar = {place.left + markWidth, place.top + above, barWidth, place.height - above - half};
    LabelColumn labels(layout.bar, measure);
    const auto ticks = ticksFor(axis, place.height, measure);
    for (const Isovalue& isovalue : content.isovalues.value_or(std::vector<Isovalue>{})) {
        AxisMark mark{positionOf(isovalue.value, axis, layout.bar), {}, !axis.contains(isovalue.value)};
        if (!content.transfer && !mark.beyond) // else the axis is there to tell
            labels.label(mark,
                         barValueText(axis, isovalue.value, ticks, content.language.numbers, content.state.numbers));
        layout.isovalues.push_back(mark);
    }
    const auto texts = barTickTexts(axis, ticks, content.language.numbers, content.state.numbers);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        AxisMark mark{positionOf(ticks[i], axis, layout.bar), {}};
        labels.label(mark, texts[i]);
        layout.ticks.push_back(mark);
    }
    return layout;
}

} // namespace tetra
