// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to the camera: axes and scale bar; and texts.
#include "core/base/text.h"
#include "core/picture/annotations/annotation_parts.h"
#include "core/picture/annotations/axis_ticks.h"
#include "core/picture/annotations/picture_projection.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tetra {
namespace {

constexpr double axisLength = 30;
constexpr double labelDistance = 9; ///< from the tip of an axis to the middle of its label
constexpr double longestBar = 180;
constexpr double longestShare = 0.28; ///< of the picture's width
constexpr double tickHeight = 7;

/// Away from the others, along the axis or beside it.
void placeLabel(AxisLayout& axis, const Eigen::Vector2d& origin, const std::vector<Rectangle>& taken,
                const TextMeasure& measure)
{
    const double length = axis.tip.norm();
    const Eigen::Vector2d along = length > 1 ? Eigen::Vector2d(axis.tip / length) : Eigen::Vector2d(0.6, -0.8);
    const Eigen::Vector2d aside(-along.y(), along.x());
    axis.label.place = {0, 0, measure.width(axis.label.text), measure.height};
    for (const double shift : {0.0, 1.0, -1.0, 2.0, -2.0}) {
        const Eigen::Vector2d middle =
            origin + axis.tip + along * labelDistance + aside * (shift * 0.9 * measure.height);
        axis.label.place = axis.label.place.centredAt(middle);
        if (std::ranges::none_of(taken, [&](const Rectangle& other) { return other.intersects(axis.label.place); }))
            return;
    }
}

double unitsPerPixelOf(const AnnotationContent& content, const Size& picture)
{
    return PictureProjection(content.camera, picture).unitsPerPixel(content.camera.target);
}

/// In the units of the dataset: nothing longer fits.
double barUnits(const AnnotationContent& content, const Size& picture)
{
    const double pixels = std::min(longestBar, longestShare * picture.width);
    return niceLength(pixels * unitsPerPixelOf(content, picture));
}

std::string barText(const AnnotationContent& content, double units)
{
    const NumberFormat& format = content.state.lengths;
    const bool isAutomatic = format.style == NumberFormat::Style::Automatic;
    const std::string number = isAutomatic ? shortNumber(units, content.language.numbers)
                                           : formattedNumber(units, format, content.language.numbers);
    const bool atTarget = content.camera.perspective;
    if (!content.lengthUnit.empty())
        return atTarget ? content.language.say(Message::say("%1 %2 at the target", number, content.lengthUnit))
                        : number + " " + content.lengthUnit;
    if (units == 1 && isAutomatic)
        return content.language.say(atTarget ? Message::say("1 unit at the target") : Message::say("1 unit"));
    return content.language.say(atTarget ? Message::say("%1 units at the target", number)
                                         : Message::say("%1 units", number));
}

/// Where its characters begin, and its end.
std::vector<std::size_t> startsOf(std::string_view text)
{
    std::vector<std::size_t> starts{0};
    while (starts.back() < text.size())
        starts.push_back(starts.back() + firstCharacter(text.substr(starts.back())).bytes);
    return starts;
}

} // namespace

Size axesSize(const TextMeasure& measure)
{
    const double side = 2 * (axisLength + labelDistance + std::ceil(measure.height / 2));
    return {side, side};
}

AxesLayout layOutAxes(const AnnotationContent& content, const Rectangle& place, const TextMeasure& measure)
{
    AxesLayout layout;
    layout.origin = place.centre();
    const std::string letters = content.space.size() == 3 ? content.space : std::string("xyz");
    const Eigen::Matrix3d rotation = viewMatrix(content.camera).topLeftCorner<3, 3>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d seen = rotation.col(static_cast<Eigen::Index>(axis));
        layout.axes[axis].tip = Eigen::Vector2d(seen.x(), -seen.y()) * axisLength;
        layout.axes[axis].depth = seen.z();
        layout.axes[axis].label.text = letters.substr(axis, 1);
    }
    // The longest first: it is the one whose place is clear.
    std::array<AxisLayout*, 3> order{&layout.axes[0], &layout.axes[1], &layout.axes[2]};
    std::ranges::stable_sort(order, {}, [](const AxisLayout* axis) { return std::abs(axis->depth); });
    std::vector<Rectangle> taken;
    for (AxisLayout* axis : order) {
        placeLabel(*axis, layout.origin, taken, measure);
        taken.push_back(axis->label.place);
    }
    return layout;
}

Size scaleBarSize(const AnnotationContent& content, const Size& picture, const TextMeasure& measure)
{
    const double units = barUnits(content, picture);
    if (!(units > 0))
        return {};
    const double bar = units / unitsPerPixelOf(content, picture);
    return {std::max(bar, measure.width(barText(content, units))) + 2, measure.height + tickHeight + 2};
}

ScaleBarLayout layOutScaleBar(const AnnotationContent& content, const Size& picture, const Rectangle& place,
                              const TextMeasure& measure)
{
    ScaleBarLayout layout;
    layout.length = barUnits(content, picture);
    const double bar = layout.length / unitsPerPixelOf(content, picture);
    const double middle = place.centre().x(),
                 y = place.bottom() - std::ceil(tickHeight / 2) - 1; // a whole number, for sharpness
    layout.from = {middle - bar / 2, y};
    layout.to = {middle + bar / 2, y};
    layout.label = fittedText(barText(content, layout.length), place.width, measure);
    layout.label.place = layout.label.place.centredAt({middle, place.top + measure.height / 2});
    return layout;
}

PlacedText fittedText(const std::string& text, double most, const TextMeasure& measure)
{
    constexpr std::size_t mostKept = 4096; // wider than any picture
    const auto starts = startsOf(text);
    const std::size_t size = starts.size() - 1;
    const auto shortened = [&](std::size_t kept) {
        return text.substr(0, starts[(kept + 1) / 2]) + "…" + text.substr(starts[size - kept / 2]);
    };
    std::string fitted = text;
    if (size > mostKept || measure.width(text) > most) {
        std::size_t fits = std::min<std::size_t>(1, size), tooLong = std::min(size, mostKept);
        while (tooLong > fits + 1) {
            const std::size_t kept = (fits + tooLong) / 2;
            (measure.width(shortened(kept)) > most ? tooLong : fits) = kept;
        }
        fitted = shortened(fits);
    }
    return {fitted, {0, 0, std::ceil(measure.width(fitted)), measure.height}};
}

} // namespace tetra
