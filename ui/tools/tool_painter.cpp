// SPDX-License-Identifier: GPL-3.0-or-later
// Tools over the picture, in the look of the annotations: one colour that is legible on the background, with a rim.
#include "ui/tools/tool_painter.h"

#include "plugins/widgets/colour_button.h"
#include "ui/session/message_text.h"
#include "ui/viewport/view_projection.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <optional>
#include <tuple>

namespace tetra {
namespace {

constexpr int toolTextSize = 12;   ///< pixels, as those of annotations
constexpr double toolTextGap = 10; ///< from the place to its text
constexpr double toolRim = 3;
constexpr double handleSize = 5;
constexpr double grownHandleSize = 7;
constexpr double nearestDepth = 2e-3; ///< of the target's distance; what is nearer to the eye is not painted

struct Strokes {
    QColor line;
    QColor rim;
};

Strokes strokesOn(const Colour& background)
{
    const bool isDark = 0.3 * background.red + 0.59 * background.green + 0.11 * background.blue < 0.5;
    Strokes strokes{isDark ? QColor(238, 238, 238) : QColor(28, 28, 30), qtColour(background)};
    strokes.rim.setAlphaF(0.8F);
    return strokes;
}

QColor inkOf(const std::optional<Colour>& own, const Strokes& strokes)
{
    return own ? qtColour(*own) : strokes.line;
}

/// A segment as it is seen: in perspective without what lies behind the eye.
class SegmentProjection {
public:
    SegmentProjection(const Camera& camera, QSizeF picture)
        : projection_(camera, picture), eye_(eyePosition(camera)), perspective_(camera.perspective),
          nearest_(nearestDepth * camera.distance)
    {
    }

    std::optional<QPointF> pixelOf(const Eigen::Vector3d& place) const { return projection_.pixelOf(place); }
    std::optional<QLineF> lineOf(Eigen::Vector3d from, Eigen::Vector3d to) const
    {
        if (perspective_) {
            const double fromDepth = depthOf(from), toDepth = depthOf(to);
            if (fromDepth < nearest_ && toDepth < nearest_)
                return std::nullopt;
            const Eigen::Vector3d crossing =
                fromDepth == toDepth ? from : from + (nearest_ - fromDepth) / (toDepth - fromDepth) * (to - from);
            if (fromDepth < nearest_)
                from = crossing;
            else if (toDepth < nearest_)
                to = crossing;
        }
        const auto start = pixelOf(from), end = pixelOf(to);
        return start && end ? std::optional(QLineF(*start, *end)) : std::nullopt;
    }

private:
    double depthOf(const Eigen::Vector3d& place) const { return projection_.towardsViewer().dot(eye_ - place); }

    ViewProjection projection_;
    Eigen::Vector3d eye_;
    bool perspective_;
    double nearest_;
};

void paintToolLine(QPainter& painter, const ToolLine& line, const SegmentProjection& seen, const Strokes& strokes)
{
    std::vector<QLineF> segments;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i)
        if (const auto segment = seen.lineOf(line.points[i], line.points[(i + 1) % count]))
            segments.push_back(*segment);
    const QColor own = inkOf(line.colour, strokes);
    for (const auto& [colour, width, style] :
         {std::tuple(strokes.rim, line.width + 2, Qt::SolidLine),
          std::tuple(own, line.width, line.dashed ? Qt::DashLine : Qt::SolidLine)}) {
        painter.setPen(QPen(colour, width, style, Qt::RoundCap));
        painter.drawLines(segments.data(), static_cast<int>(segments.size()));
    }
}

void paintToolPoint(QPainter& painter, QPointF place, const ToolPoint& point, const Strokes& strokes)
{
    painter.setPen(QPen(strokes.rim, 1.5));
    painter.setBrush(inkOf(point.colour, strokes));
    painter.drawEllipse(place, point.radius + 1, point.radius + 1);
    painter.setBrush(Qt::NoBrush);
}

/// To the right of the place, or to the left where there is no room.
void paintToolText(QPainter& painter, QPointF place, const QString& text, QSizeF picture, const Strokes& strokes)
{
    const QFontMetricsF metrics(painter.font());
    const double width = metrics.horizontalAdvance(text);
    const double right = place.x() + toolTextGap;
    const bool fits = right + width <= picture.width();
    const QPointF baseline(fits ? right : place.x() - toolTextGap - width,
                           place.y() + (metrics.ascent() - metrics.descent()) / 2);
    QPainterPath outline;
    outline.addText(baseline, painter.font(), text);
    painter.strokePath(outline, QPen(strokes.rim, toolRim, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setPen(strokes.line);
    painter.drawText(baseline, text);
}

/// Hollow if it is selected.
void paintToolHandle(QPainter& painter, QPointF place, const ToolHandle& handle, const ToolInk& ink,
                     const Strokes& strokes)
{
    const double size = handle.id == ink.hovered ? grownHandleSize : handleSize;
    const auto draw = [&](double radius) {
        if (handle.square)
            painter.drawRect(QRectF(place.x() - radius, place.y() - radius, 2 * radius, 2 * radius));
        else
            painter.drawEllipse(place, radius, radius);
    };
    painter.setPen(QPen(strokes.rim, 1.5));
    painter.setBrush(strokes.line);
    draw(size + 1);
    if (handle.id == ink.selected) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(strokes.rim);
        draw(size / 2.5);
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace

void paintTool(QPainter& painter, const ToolDrawing& drawing, const ToolInk& ink, QSizeF picture)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = ink.font;
    font.setPixelSize(toolTextSize);
    painter.setFont(font);
    const Strokes strokes = strokesOn(ink.background);
    const SegmentProjection seen(ink.camera, picture);
    for (const ToolLine& line : drawing.lines)
        paintToolLine(painter, line, seen, strokes);
    for (const ToolPoint& point : drawing.points)
        if (const auto pixel = seen.pixelOf(point.place))
            paintToolPoint(painter, *pixel, point, strokes);
    for (const ToolHandle& handle : drawing.handles)
        if (const auto pixel = seen.pixelOf(handle.place))
            paintToolHandle(painter, *pixel, handle, ink, strokes);
    for (const ToolText& text : drawing.texts)
        if (const auto pixel = seen.pixelOf(text.place))
            paintToolText(painter, *pixel, translatedMessage(text.text), picture, strokes);
    painter.restore();
}

void paintTools(QImage& image, const std::vector<ToolDrawing>& drawings, const ToolInk& ink, double scale)
{
    if (drawings.empty())
        return;
    const QImage::Format format = image.format();
    // Painting translucent ink over straight alpha is slow and coarse.
    image = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    {
        QPainter painter(&image);
        painter.scale(scale, scale);
        for (const ToolDrawing& drawing : drawings)
            paintTool(painter, drawing, ink, QSizeF(image.size()) / scale);
    }
    image = image.convertToFormat(format);
}

} // namespace tetra
