// SPDX-License-Identifier: GPL-3.0-or-later
// Tools over a picture, in the look of the annotations: places of the dataset become places of the picture, what lies
// behind the eye or far beside the picture is cut off, and the rest is painted in one ink that is legible on the
// background, with a rim.
#include "core/picture/tool_painter.h"

#include "core/picture/annotations/picture_projection.h"
#include "core/picture/annotations/placed_text.h"
#include "core/picture/drawing/canvas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr double textGap = 10;           ///< from the place to its text
constexpr double rim = 1;                ///< around lines and shapes
constexpr double handleRadius = 6;       ///< or half a side
constexpr double hoveredGrowth = 2;      ///< of that, under the pointer
constexpr double hollowPart = 0.4;       ///< of that, if it is selected
constexpr double dashLength = 4;         ///< in widths of the line
constexpr double dashPeriod = 6;         ///< likewise
constexpr double nearestDepth = 2e-3;    ///< of the target's distance; what is nearer to the eye is not painted
constexpr double beside = 256;           ///< as far beside the picture lines are painted
constexpr std::size_t mostPoints = 1000; ///< of a line that is stroked at once

/// A segment in the picture: what is left of it.
struct SeenSegment {
    Eigen::Vector2d from{0, 0};
    Eigen::Vector2d to{0, 0};
    double before = 0; ///< the length that was cut off at its beginning
    double length = 0; ///< with what was cut off
};

/// What of the line from + t (to - from), t in 0 ... 1, lies in the rectangle (Liang and Barsky 1984).
std::optional<std::pair<double, double>> partWithin(const Rectangle& rectangle, const Eigen::Vector2d& from,
                                                    const Eigen::Vector2d& to)
{
    const Eigen::Vector2d lower(rectangle.left, rectangle.top), upper(rectangle.right(), rectangle.bottom());
    double first = 0, last = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double step = to[axis] - from[axis];
        if (step == 0) {
            if (from[axis] < lower[axis] || from[axis] > upper[axis])
                return std::nullopt;
            continue;
        }
        const double one = (lower[axis] - from[axis]) / step, other = (upper[axis] - from[axis]) / step;
        first = std::max(first, std::min(one, other));
        last = std::min(last, std::max(one, other));
    }
    return first < last ? std::optional(std::pair(first, last)) : std::nullopt;
}

/// Where places of the dataset are seen in a picture.
class SeenPlaces {
public:
    SeenPlaces(const Camera& camera, const Size& picture)
        : projection_(camera, picture), eye_(eyePosition(camera)), perspective_(camera.perspective),
          nearest_(nearestDepth * camera.distance),
          surroundings_(Rectangle{0, 0, picture.width, picture.height}.grown(beside))
    {
    }

    std::optional<Eigen::Vector2d> placeOf(const Eigen::Vector3d& place) const
    {
        const auto seen = projection_.pixelOf(place);
        const bool isNear = seen && surroundings_.contains({seen->x(), seen->y(), 0, 0});
        return isNear ? seen : std::nullopt;
    }

    std::optional<SeenSegment> segmentOf(Eigen::Vector3d from, Eigen::Vector3d to) const
    {
        if (perspective_ && !cutBehindEye(from, to))
            return std::nullopt;
        const auto start = projection_.pixelOf(from), end = projection_.pixelOf(to);
        if (!start || !end)
            return std::nullopt;
        const Eigen::Vector2d step = *end - *start;
        if (!step.allFinite())
            return std::nullopt;
        SeenSegment segment{*start, *end, 0, step.norm()};
        const auto part = partWithin(surroundings_, *start, *end);
        if (!part)
            return std::nullopt;
        if (part->first > 0)
            segment.from = *start + part->first * step;
        if (part->second < 1)
            segment.to = *start + part->second * step;
        segment.before = part->first * segment.length;
        return segment;
    }

private:
    double depthOf(const Eigen::Vector3d& place) const { return projection_.towardsViewer().dot(eye_ - place); }

    /// False if nothing is left.
    bool cutBehindEye(Eigen::Vector3d& from, Eigen::Vector3d& to) const
    {
        const double fromDepth = depthOf(from), toDepth = depthOf(to);
        if (fromDepth < nearest_ && toDepth < nearest_)
            return false;
        if (fromDepth < nearest_)
            from += (nearest_ - fromDepth) / (toDepth - fromDepth) * (to - from);
        else if (toDepth < nearest_)
            to = from + (nearest_ - fromDepth) / (toDepth - fromDepth) * (to - from);
        return true;
    }

    PictureProjection projection_;
    Eigen::Vector3d eye_;
    bool perspective_;
    double nearest_;
    Rectangle surroundings_;
};

/// A piece of a line that is seen without a break.
struct Stretch {
    std::vector<Eigen::Vector2d> points{};
    double begin = 0; ///< where it begins, from the beginning of the line
};

void append(std::vector<Stretch>& stretches, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double begin)
{
    const bool goesOn =
        !stretches.empty() && stretches.back().points.back() == from && stretches.back().points.size() < mostPoints;
    if (!goesOn)
        stretches.push_back({{from}, begin});
    stretches.back().points.push_back(to);
}

std::vector<Stretch> stretchesOf(const ToolLine& line, const SeenPlaces& seen)
{
    std::vector<Stretch> stretches;
    double along = 0;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i)
        if (const auto segment = seen.segmentOf(line.points[i], line.points[(i + 1) % count])) {
            append(stretches, segment->from, segment->to, along + segment->before);
            along += segment->length;
        }
    return stretches;
}

/// Round the corners, too.
std::vector<Stretch> dashesOf(const Stretch& stretch, double width)
{
    const double period = dashPeriod * width, dash = dashLength * width;
    std::vector<Stretch> dashes;
    double begin = std::fmod(stretch.begin, period); // small, so that steps of a period do not vanish
    for (std::size_t i = 0; i + 1 < stretch.points.size(); ++i) {
        const Eigen::Vector2d &from = stretch.points[i], &to = stretch.points[i + 1];
        const double length = (to - from).norm();
        const auto placeAt = [&](double along) -> Eigen::Vector2d {
            return from + std::clamp((along - begin) / length, 0.0, 1.0) * (to - from);
        };
        for (double start = std::floor(begin / period) * period; start < begin + length; start += period)
            if (start + dash > begin)
                append(dashes, placeAt(start), placeAt(start + dash), std::max(start, begin));
        begin += length;
    }
    return dashes;
}

struct Brush {
    const PixelCanvas& canvas;
    AnnotationInk ink;
    Size picture;
};

PixelInk inkOf(const std::optional<Colour>& own, const AnnotationInk& usual)
{
    return own ? inkOf(*own) : usual.line;
}

void strokeAll(const PixelCanvas& canvas, std::span<const Stretch> stretches, double width, const PixelInk& ink,
               LineEnd end = LineEnd::Square)
{
    for (const Stretch& stretch : stretches)
        strokeOpen(canvas, stretch.points, width, ink, end);
}

void paintLine(const Brush& brush, const ToolLine& line, const SeenPlaces& seen)
{
    const std::vector<Stretch> stretches = stretchesOf(line, seen);
    strokeAll(brush.canvas, stretches, line.width + 2 * rim, brush.ink.rim);
    const PixelInk ink = inkOf(line.colour, brush.ink);
    if (!line.dashed)
        return strokeAll(brush.canvas, stretches, line.width, ink);
    for (const Stretch& stretch : stretches)
        strokeAll(brush.canvas, dashesOf(stretch, std::max(line.width, 1.0)), line.width, ink, LineEnd::Flat);
}

Rectangle around(const Eigen::Vector2d& place, double radius)
{
    return {place.x() - radius, place.y() - radius, 2 * radius, 2 * radius};
}

void paintPoint(const Brush& brush, const Eigen::Vector2d& place, const ToolPoint& point)
{
    fill(brush.canvas, ellipsePath(around(place, point.radius + 2 * rim)), brush.ink.rim);
    fill(brush.canvas, ellipsePath(around(place, point.radius + rim)), inkOf(point.colour, brush.ink));
}

/// Hollow if it is selected.
void paintHandle(const Brush& brush, const Eigen::Vector2d& place, const ToolHandle& handle, const ToolInk& ink)
{
    const double radius = handleRadius + (handle.id == ink.hovered ? hoveredGrowth : 0);
    const auto paint = [&](double size, const PixelInk& with) {
        const Rectangle box = around(place, size);
        fill(brush.canvas, handle.square ? rectanglePath(box) : ellipsePath(box), with);
    };
    paint(radius + rim, brush.ink.rim);
    paint(radius, brush.ink.line);
    if (handle.id == ink.selected)
        paint(radius * hollowPart, brush.ink.rim);
}

/// To the right of the place, or to the left where there is no room.
void paintTextBeside(const Brush& brush, const Fonts& fonts, const Eigen::Vector2d& place, const std::string& text)
{
    const double width = measured(fonts, text, annotationText).advance;
    const double right = place.x() + textGap;
    const double left = right + width <= brush.picture.width ? right : place.x() - textGap - width;
    paintPlacedText(brush.canvas, fonts, text, {left, place.y() - 1, width, 2}, brush.ink);
}

} // namespace

Status paintTools(const PixelView& picture, std::span<const ToolDrawing> drawings, const ToolInk& ink, double scale)
{
    return paintTools(PixelCanvas(picture, scale), drawings, ink);
}

Status paintTools(const PixelCanvas& canvas, std::span<const ToolDrawing> drawings, const ToolInk& ink)
{
    std::shared_ptr<const Fonts> fonts = ink.fonts;
    if (!fonts && std::ranges::any_of(drawings, [](const ToolDrawing& drawing) { return !drawing.texts.empty(); })) {
        const auto opened = openFonts();
        if (!opened)
            return opened.error();
        fonts = *opened;
    }
    const Brush brush{canvas, annotationInk(ink.background), canvas.size()};
    const SeenPlaces seen(ink.camera, brush.picture);
    for (const ToolDrawing& drawing : drawings) {
        for (const ToolLine& line : drawing.lines)
            paintLine(brush, line, seen);
        for (const ToolPoint& point : drawing.points)
            if (const auto place = seen.placeOf(point.place))
                paintPoint(brush, *place, point);
        for (const ToolHandle& handle : drawing.handles)
            if (const auto place = seen.placeOf(handle.place))
                paintHandle(brush, *place, handle, ink);
        for (const ToolText& text : drawing.texts)
            if (const auto place = seen.placeOf(text.place))
                paintTextBeside(brush, *fonts, *place, ink.language.say(text.text));
    }
    return {};
}

} // namespace tetra
