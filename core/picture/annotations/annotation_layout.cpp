// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/annotation_layout.h"

#include "core/base/text.h"
#include "core/picture/annotations/annotation_parts.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double margin = 14; ///< to the edges of the picture
constexpr double gap = 12;    ///< between annotations
constexpr double tallestBar = 260;
constexpr double tallestShare = 0.62; ///< of the picture's height, for the bar and its name
constexpr double shortestBar = 76;
constexpr double barStep = 12;
/// As annotations stand in a corner, from the edge on.
constexpr std::array stackingOrder{AnnotationKind::Title, AnnotationKind::Accuracy, AnnotationKind::ColourBar,
                                   AnnotationKind::ScaleBar, AnnotationKind::Axes};
/// What goes first if there is no room.
constexpr std::array leastFirst{AnnotationKind::Accuracy, AnnotationKind::Title, AnnotationKind::Axes,
                                AnnotationKind::ScaleBar, AnnotationKind::ColourBar};

using Sizes = std::array<Size, annotationCount>;
using Places = std::array<Rectangle, annotationCount>;

std::size_t indexOf(AnnotationKind kind)
{
    return static_cast<std::size_t>(kind);
}

bool isTop(Corner corner)
{
    return corner == Corner::TopLeft || corner == Corner::TopRight;
}

bool isLeft(Corner corner)
{
    return corner == Corner::TopLeft || corner == Corner::BottomLeft;
}

/// Of a place `offset` from the corner.
Rectangle placeIn(Corner corner, double offset, const Size& size, const Size& picture)
{
    const double left = isLeft(corner) ? margin : picture.width - margin - size.width;
    const double top = isTop(corner) ? margin + offset : picture.height - margin - offset - size.height;
    return {left, top, size.width, size.height};
}

/// Places for all that have a size; nothing if they do not fit.
std::optional<Places> placed(const AnnotationState& state, const Sizes& sizes, const Size& picture)
{
    const Rectangle room = Rectangle{0, 0, picture.width, picture.height}.grown(-margin);
    const double touch = gap / 2;
    Places places{};
    std::array<double, 4> offsets{};
    for (const AnnotationKind kind : stackingOrder) {
        const Size& size = sizes[indexOf(kind)];
        if (size.isEmpty())
            continue;
        double& offset = offsets[static_cast<std::size_t>(state[kind].corner)];
        const Rectangle place = placeIn(state[kind].corner, offset, size, picture);
        const Rectangle wide = place.grown(touch);
        const auto touches = [&](const Rectangle& other) { return wide.intersects(other); };
        // Lines of text in one corner may stand close.
        const bool isText = kind == AnnotationKind::Title || kind == AnnotationKind::Accuracy;
        if (!room.contains(place) || (!isText && std::ranges::any_of(places, touches)) ||
            std::ranges::any_of(places, [&](const Rectangle& other) { return place.intersects(other); }))
            return std::nullopt;
        places[indexOf(kind)] = place;
        offset += size.height + (kind == AnnotationKind::Title ? 0 : gap);
    }
    return places;
}

Size textSize(const std::string& text, double most, const TextMeasure& measure)
{
    return text.empty() ? Size() : fittedText(text, most, measure).place.size();
}

TextMeasure inBold(const TextMeasure& measure)
{
    return {measure.boldWidth, measure.boldWidth, measure.height};
}

std::string titleOf(const AnnotationContent& content)
{
    return content.state.title.empty() ? content.title : visibleText(content.state.title);
}

/// Without the colour bar, whose height is to be found.
Sizes sizesOf(const AnnotationContent& content, const Size& picture, const TextMeasure& measure)
{
    const double widest = picture.width * 0.6;
    Sizes sizes{};
    sizes[indexOf(AnnotationKind::Axes)] = axesSize(measure);
    sizes[indexOf(AnnotationKind::ScaleBar)] = scaleBarSize(content, picture, measure);
    sizes[indexOf(AnnotationKind::Title)] = textSize(titleOf(content), widest, inBold(measure));
    sizes[indexOf(AnnotationKind::Accuracy)] = textSize(content.accuracy, widest, measure);
    for (std::size_t i = 0; i < annotationCount; ++i)
        if (!content.state.places[i].shown)
            sizes[i] = {};
    return sizes;
}

/// The places with the highest colour bar that fits.
std::optional<Places> withHighestBar(const AnnotationContent& content, const BarAxis& axis, Sizes sizes, bool bar,
                                     const Size& picture, const TextMeasure& measure)
{
    Size& size = sizes[indexOf(AnnotationKind::ColourBar)];
    if (!bar || colourBarSize(content, axis, shortestBar, picture, measure).isEmpty())
        return placed(content.state, sizes, picture);
    const double highest = std::clamp(std::floor(picture.height * tallestShare), shortestBar, tallestBar);
    for (double height = highest; height >= shortestBar; height -= barStep) {
        size = colourBarSize(content, axis, height, picture, measure);
        if (auto places = placed(content.state, sizes, picture))
            return places;
    }
    return std::nullopt;
}

/// The places of as many as fit: `dropped` has a bit for each that is left out, the least important first.
Places placesOf(const AnnotationContent& content, const BarAxis& axis, const Size& picture, const TextMeasure& measure)
{
    const Sizes sizes = sizesOf(content, picture, measure);
    for (unsigned dropped = 0; dropped < (1U << leastFirst.size()); ++dropped) {
        Sizes kept = sizes;
        bool bar = content.state[AnnotationKind::ColourBar].shown;
        for (std::size_t i = 0; i < leastFirst.size(); ++i)
            if ((dropped >> i & 1U) != 0) {
                kept[indexOf(leastFirst[i])] = {};
                bar = bar && leastFirst[i] != AnnotationKind::ColourBar;
            }
        if (const auto places = withHighestBar(content, axis, kept, bar, picture, measure))
            return *places;
    }
    return {};
}

} // namespace

AnnotationLayout layOutAnnotations(const AnnotationContent& content, const Size& picture, const TextMeasure& measure)
{
    AnnotationLayout layout;
    const BarAxis axis = barAxisOf(content);
    layout.places = placesOf(content, axis, picture, measure);
    const auto place = [&](AnnotationKind kind) { return layout.places[indexOf(kind)]; };
    const auto has = [&](AnnotationKind kind) { return !place(kind).isEmpty(); };
    if (has(AnnotationKind::ColourBar))
        layout.colourBar = layOutColourBar(content, axis, place(AnnotationKind::ColourBar), measure);
    if (has(AnnotationKind::Axes))
        layout.axes = layOutAxes(content, place(AnnotationKind::Axes), measure);
    if (has(AnnotationKind::ScaleBar))
        layout.scaleBar = layOutScaleBar(content, picture, place(AnnotationKind::ScaleBar), measure);
    const auto textAt = [&](AnnotationKind kind, const std::string& text, const TextMeasure& widths) {
        PlacedText placed = fittedText(text, place(kind).width + 0.5, widths);
        placed.place = place(kind);
        return placed;
    };
    if (has(AnnotationKind::Title))
        layout.title = textAt(AnnotationKind::Title, titleOf(content), inBold(measure));
    if (has(AnnotationKind::Accuracy))
        layout.accuracy = textAt(AnnotationKind::Accuracy, content.accuracy, measure);
    if (content.state[AnnotationKind::BoxAxes].shown)
        layout.boxAxes = layOutBoxAxes(content, picture, {layout.places.begin(), layout.places.end()}, measure);
    return layout;
}

} // namespace tetra
