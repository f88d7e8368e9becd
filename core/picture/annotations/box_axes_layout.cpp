// SPDX-License-Identifier: GPL-3.0-or-later
// Axes with numbers along the edges of the data's box: which edges, by the camera, and which numbers there is room for.
#include "core/picture/annotations/annotation_parts.h"
#include "core/picture/annotations/axis_ticks.h"
#include "core/picture/annotations/picture_projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace tetra {
namespace {

constexpr double markLength = 5;
constexpr double numberGap = 4;      ///< from a tick to its number, and from the numbers to the name
constexpr double textsApart = 4;     ///< of texts, at least
constexpr double linesPerNumber = 2; ///< numbers stand no denser
constexpr int mostNumbers = 100;
constexpr std::size_t fewestNumbers = 2; ///< one number alone tells no length

/// An edge of the box in the picture.
struct SeenEdge {
    std::size_t axis = 0;
    Eigen::Vector3d least{0, 0, 0}, largest{0, 0, 0}; ///< its ends in space
    Eigen::Vector2d from{0, 0}, to{0, 0};             ///< and in the picture
    Eigen::Vector2d outwards{0, 0};
};

/// The place of a side of the box: 0 is the smaller end, 1 the larger one.
double sideAt(const Eigen::AlignedBox3d& box, std::size_t axis, int side)
{
    return (side == 0 ? box.min() : box.max())[static_cast<Eigen::Index>(axis)];
}

/// Whether a face is turned towards the viewer; one that is seen edge-on is not.
bool isSeen(const AnnotationContent& content, const PictureProjection& projection, std::size_t axis, int side)
{
    constexpr double edgeOn = 1e-9;
    const auto at = static_cast<Eigen::Index>(axis);
    const double sign = side == 0 ? -1 : 1;
    if (content.camera.perspective)
        return sign * (eyePosition(content.camera)[at] - sideAt(content.box, axis, side)) > 0;
    return sign * projection.towardsViewer()[at] > edgeOn;
}

/// The edge if it is on the outline of the box as it is seen, where nothing of the box lies on one side of it.
std::optional<SeenEdge> outerEdge(const AnnotationContent& content, const PictureProjection& projection,
                                  std::size_t axis, const std::array<int, 2>& sides)
{
    const std::array<std::size_t, 2> others{(axis + 1) % 3, (axis + 2) % 3};
    if (isSeen(content, projection, others[0], sides[0]) == isSeen(content, projection, others[1], sides[1]))
        return std::nullopt;
    SeenEdge edge{.axis = axis};
    for (std::size_t i = 0; i < 2; ++i)
        edge.least[static_cast<Eigen::Index>(others[i])] = sideAt(content.box, others[i], sides[i]);
    edge.largest = edge.least;
    edge.least[static_cast<Eigen::Index>(axis)] = sideAt(content.box, axis, 0);
    edge.largest[static_cast<Eigen::Index>(axis)] = sideAt(content.box, axis, 1);
    const auto from = projection.pixelOf(edge.least), to = projection.pixelOf(edge.largest);
    const auto middle = projection.pixelOf(content.box.center());
    if (!from || !to || !middle || (*to - *from).norm() < 1)
        return std::nullopt;
    edge.from = *from;
    edge.to = *to;
    const Eigen::Vector2d along = (*to - *from).normalized();
    edge.outwards = {along.y(), -along.x()};
    if (edge.outwards.dot(*middle - *from) > 0)
        edge.outwards = -edge.outwards;
    return edge;
}

/// Those of one axis, the best first: below the box rather than above it, left rather than right.
std::vector<SeenEdge> outerEdges(const AnnotationContent& content, const PictureProjection& projection,
                                 std::size_t axis)
{
    const Eigen::Vector2d preferred(-0.6, 1);
    std::vector<SeenEdge> edges;
    for (int sides = 0; sides < 4; ++sides)
        if (const auto edge = outerEdge(content, projection, axis, {sides & 1, sides >> 1}))
            edges.push_back(*edge);
    std::ranges::stable_sort(edges, std::greater(), [&](const SeenEdge& edge) { return edge.outwards.dot(preferred); });
    return edges;
}

/// The part of a line from one point to another that lies in the picture, as shares of it.
std::optional<std::pair<double, double>> partIn(const Rectangle& picture, const Eigen::Vector2d& from,
                                                const Eigen::Vector2d& to)
{
    double begin = 0, end = 1;
    const Eigen::Vector2d along = to - from;
    const auto keep = [&](double position, double step, double least, double most) {
        if (step == 0)
            return position >= least && position <= most;
        const double one = (least - position) / step, other = (most - position) / step;
        begin = std::max(begin, std::min(one, other));
        end = std::min(end, std::max(one, other));
        return begin < end;
    };
    if (!keep(from.x(), along.x(), picture.left, picture.right()) ||
        !keep(from.y(), along.y(), picture.top, picture.bottom()))
        return std::nullopt;
    return std::pair(begin, end);
}

/// A text outside of a line through a place: nothing of it lies nearer to the line than `distance`.
PlacedText textOutside(const std::string& text, const Eigen::Vector2d& place, const Eigen::Vector2d& outwards,
                       double distance, const TextMeasure& measure)
{
    PlacedText placed{text, {0, 0, std::ceil(measure.width(text)), measure.height}};
    const double reach =
        (std::abs(outwards.x()) * placed.place.width + std::abs(outwards.y()) * placed.place.height) / 2;
    placed.place = placed.place.centredAt(place + outwards * (distance + reach));
    return placed;
}

bool touches(const Rectangle& place, const std::vector<Rectangle>& taken)
{
    const Rectangle wide = place.grown(textsApart / 2);
    return std::ranges::any_of(taken, [&](const Rectangle& other) { return wide.intersects(other); });
}

std::vector<std::string> textsOf(const AnnotationContent& content, const std::vector<double>& values)
{
    const NumberSigns& signs = content.language.numbers;
    if (content.state.lengths.style == NumberFormat::Style::Automatic)
        return tickTexts(values, signs);
    std::vector<std::string> texts;
    for (const double value : values)
        texts.push_back(formattedNumber(value, content.state.lengths, signs));
    return texts;
}

/// The edge with these values, whose numbers are seen in the picture; nothing if two of them would touch.
std::optional<BoxAxisLayout> withTicks(const AnnotationContent& content, const PictureProjection& projection,
                                       const SeenEdge& edge, const std::vector<double>& values, const Rectangle& room,
                                       const TextMeasure& measure)
{
    BoxAxisLayout layout{.axis = edge.axis, .outwards = edge.outwards};
    const auto texts = textsOf(content, values);
    const Rectangle* last = nullptr;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Eigen::Vector3d place = edge.least;
        place[static_cast<Eigen::Index>(edge.axis)] = values[i];
        const auto pixel = projection.pixelOf(place);
        if (!pixel || !room.contains({pixel->x(), pixel->y(), 0, 0}))
            continue;
        layout.ticks.push_back(
            {values[i], *pixel, textOutside(texts[i], *pixel, edge.outwards, markLength + numberGap, measure)});
    }
    for (const BoxTick& tick : layout.ticks) {
        if (last != nullptr && tick.label.place.grown(textsApart / 2).intersects(last->grown(textsApart / 2)))
            return std::nullopt;
        last = &tick.label.place;
    }
    return layout;
}

/// As many round numbers as have room, but for those that touch something else, whose ticks stay.
std::optional<BoxAxisLayout> layOutEdge(const AnnotationContent& content, const PictureProjection& projection,
                                        const SeenEdge& edge, const Rectangle& room,
                                        const std::vector<Rectangle>& taken, const TextMeasure& measure)
{
    const auto part = partIn(room, edge.from, edge.to);
    if (!part)
        return std::nullopt;
    const Eigen::Vector2d along = edge.to - edge.from;
    const double lines = along.norm() / (linesPerNumber * measure.height);
    const auto axis = static_cast<Eigen::Index>(edge.axis);
    std::optional<BoxAxisLayout> layout;
    for (int most = static_cast<int>(std::min<double>(mostNumbers, lines)); most > 1 && !layout;) {
        const auto values = niceTicks(edge.least[axis], edge.largest[axis], most);
        layout = withTicks(content, projection, edge, values, room, measure);
        most = std::min(most, static_cast<int>(values.size())) - 1;
    }
    if (!layout)
        return std::nullopt;
    std::size_t labels = 0;
    for (BoxTick& tick : layout->ticks) {
        if (!room.contains(tick.label.place) || touches(tick.label.place, taken))
            tick.label = {};
        labels += tick.label.text.empty() ? 0 : 1;
    }
    layout->from = edge.from + along * part->first;
    layout->to = edge.from + along * part->second;
    return labels < fewestNumbers ? std::nullopt : layout;
}

/// The name beyond the numbers, where there is room for it.
void placeName(BoxAxisLayout& layout, const AnnotationContent& content, const Rectangle& room,
               const std::vector<Rectangle>& taken, const TextMeasure& measure)
{
    const std::string letters = content.space.size() == 3 ? content.space : std::string("xyz");
    const std::string unit = content.lengthUnit.empty() ? "" : " (" + content.lengthUnit + ")";
    double farthest = markLength;
    for (const BoxTick& tick : layout.ticks)
        if (!tick.label.text.empty()) {
            const Rectangle& place = tick.label.place;
            farthest = std::max(
                farthest,
                layout.outwards.dot(place.centre() - tick.place) +
                    (std::abs(layout.outwards.x()) * place.width + std::abs(layout.outwards.y()) * place.height) / 2);
        }
    for (const double further : {0.0, 1.0, 2.0})
        for (const double share : {0.5, 0.4, 0.6, 0.25, 0.75, 0.1, 0.9}) {
            const Eigen::Vector2d place = layout.from + (layout.to - layout.from) * share;
            const double distance = farthest + numberGap + further * measure.height;
            const PlacedText name =
                textOutside(letters.substr(layout.axis, 1) + unit, place, layout.outwards, distance, measure);
            if (room.contains(name.place) && !touches(name.place, taken)) {
                layout.name = name;
                return;
            }
        }
}

} // namespace

std::vector<BoxAxisLayout> layOutBoxAxes(const AnnotationContent& content, const Size& picture,
                                         const std::vector<Rectangle>& others, const TextMeasure& measure)
{
    constexpr double margin = 3;
    if (content.box.isEmpty() || picture.isEmpty())
        return {};
    const Rectangle room = Rectangle{0, 0, picture.width, picture.height}.grown(-margin);
    const PictureProjection projection(content.camera, picture);
    std::vector<Rectangle> taken = others;
    std::vector<BoxAxisLayout> layouts;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const SeenEdge& edge : outerEdges(content, projection, axis))
            if (auto layout = layOutEdge(content, projection, edge, room, taken, measure)) {
                for (const BoxTick& tick : layout->ticks)
                    if (!tick.label.text.empty())
                        taken.push_back(tick.label.place);
                layouts.push_back(*std::move(layout));
                break;
            }
    for (BoxAxisLayout& layout : layouts) {
        placeName(layout, content, room, taken, measure);
        if (!layout.name.text.empty())
            taken.push_back(layout.name.place);
    }
    return layouts;
}

} // namespace tetra
