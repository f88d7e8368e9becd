// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/drawing.h"

#include "core/base/file_writer.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPainter>

#include <array>
#include <span>

namespace tetra {
namespace {

struct InkColours {
    const char* name;
    QRgb light; ///< on a white ground
    QRgb dark;
};
constexpr std::size_t seriesInks = 8;
constexpr std::array<InkColours, std::size_t(Ink::Series) + seriesInks> inks = {{
    {"ground", 0xffffffff, 0xff1b1e21},
    {"text", 0xff1c1e21, 0xffe3e6e8},
    {"soft", 0xff565c63, 0xffa9b1b8},
    {"grid", 0xffdfe3e7, 0xff33393f},
    {"axis", 0xff767d85, 0xff8b939b},
    {"s0", 0xff0072b2, 0xff56b4e9},
    {"s1", 0xffd55e00, 0xfff08a4b},
    {"s2", 0xff6a7178, 0xff9aa2aa},
    {"s3", 0xff00805d, 0xff2fb891},
    {"s4", 0xffa8558a, 0xffd79cc1},
    {"s5", 0xffb07a00, 0xffe6b84d},
    {"s6", 0xff3a9bd6, 0xff8fd0f5},
    {"s7", 0xff7a7a1f, 0xffcccc66},
}};

const InkColours& coloursOf(Ink ink)
{
    return inks[std::size_t(ink)];
}

struct LetterStyle {
    int size;
    bool isBold;
};
constexpr std::array<LetterStyle, 4> letterStyles = {{{13, false}, {12, false}, {13, true}, {15, true}}};

const LetterStyle& styleOf(Letters letters)
{
    return letterStyles[std::size_t(letters)];
}

QString number(double value)
{
    return QString::number(value, 'f', 1);
}

QString colourRules(QRgb InkColours::*colour)
{
    QString rules;
    for (const InkColours& ink : inks)
        rules += QString(".%1 { color: %2; } ").arg(QString(ink.name), QColor::fromRgb(ink.*colour).name());
    return rules;
}

/// "BEFOREx,yAFTER" for each point.
QString listOf(const QPolygonF& points, const char* before, const char* after)
{
    QString list;
    for (const QPointF& point : points)
        list += before + number(point.x()) + ',' + number(point.y()) + after;
    return list;
}

std::span<const std::byte> contentOf(const QByteArray& bytes)
{
    return std::as_bytes(std::span(bytes.constData(), bytes.size()));
}

} // namespace

Ink seriesInk(std::size_t number)
{
    return static_cast<Ink>(std::size_t(Ink::Series) + number % seriesInks);
}

Drawing::Drawing(const QSizeF& size, QString title, QString description)
    : size_(size), title_(std::move(title)), description_(std::move(description))
{
    area(QPolygonF(QRectF({0, 0}, size)), Ink::Ground);
}

void Drawing::text(const QPointF& place, const QString& words, Letters letters, Anchor anchor)
{
    const Ink ink = letters == Letters::Soft ? Ink::Soft : Ink::Text;
    shapes_.push_back({Kind::Text, QPolygonF({place}), ink, 1, words, letters, anchor});
}

void Drawing::line(const QPolygonF& points, Ink ink, double width)
{
    shapes_.push_back({Kind::Line, points, ink, width});
}

void Drawing::area(const QPolygonF& border, Ink ink)
{
    shapes_.push_back({Kind::Area, border, ink});
}

void Drawing::dots(const QPolygonF& places, Ink ink, double diameter)
{
    shapes_.push_back({Kind::Dots, places, ink, diameter});
}

QString Drawing::svgOf(const Shape& shape)
{
    const QString ink = coloursOf(shape.ink).name;
    switch (shape.kind) {
    case Kind::Line:
        return QString(R"(<polyline class="%1" fill="none" stroke="currentColor" stroke-width="%2" points="%3"/>)")
            .arg(ink, number(shape.width), listOf(shape.points, "", " "));
    case Kind::Area:
        return QString(R"(<polygon class="%1" fill="currentColor" points="%2"/>)")
            .arg(ink, listOf(shape.points, "", " "));
    case Kind::Dots:
        return QString(R"(<path class="%1" stroke="currentColor" stroke-width="%2" stroke-linecap="round" d="%3"/>)")
            .arg(ink, number(shape.width), listOf(shape.points, "M", "h0"));
    case Kind::Text: break;
    }
    const char* const anchors[] = {"start", "middle", "end"};
    const auto [size, isBold] = styleOf(shape.letters);
    return QString(R"(<text class="%1" fill="currentColor" font-size="%2" font-weight="%3" text-anchor="%4" x="%5" )"
                   R"(y="%6">%7</text>)")
        .arg(ink, QString::number(size), QString(isBold ? "600" : "400"), QString(anchors[std::size_t(shape.anchor)]),
             number(shape.points[0].x()), number(shape.points[0].y()), shape.words.toHtmlEscaped());
}

QByteArray Drawing::svg() const
{
    QString text =
        QString(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %1 %2" width="%1" height="%2" )"
                R"(role="img" aria-labelledby="title description">
<title id="title">%3</title>
<desc id="description">%4</desc>
<style>
text { font-family: system-ui, sans-serif; }
%5
@media (prefers-color-scheme: dark) { %6}
</style>
)")
            .arg(QString::number(size_.width()), QString::number(size_.height()), title_.toHtmlEscaped(),
                 description_.toHtmlEscaped(), colourRules(&InkColours::light), colourRules(&InkColours::dark));
    for (const Shape& shape : shapes_)
        text += svgOf(shape) + '\n';
    return (text + "</svg>\n").toUtf8();
}

void Drawing::paint(QPainter& painter, const Shape& shape)
{
    const QColor colour = QColor::fromRgb(coloursOf(shape.ink).light);
    painter.setPen(QPen(colour, shape.width, Qt::SolidLine, shape.kind == Kind::Dots ? Qt::RoundCap : Qt::FlatCap));
    painter.setBrush(colour);
    switch (shape.kind) {
    case Kind::Line: painter.drawPolyline(shape.points); return;
    case Kind::Dots: painter.drawPoints(shape.points); return;
    case Kind::Area:
        painter.setPen(Qt::NoPen);
        painter.drawPolygon(shape.points);
        return;
    case Kind::Text: break;
    }
    QFont font = painter.font();
    font.setPixelSize(styleOf(shape.letters).size);
    font.setBold(styleOf(shape.letters).isBold);
    painter.setFont(font);
    const double width = QFontMetricsF(font).horizontalAdvance(shape.words);
    painter.drawText(shape.points[0] - QPointF(width / 2 * static_cast<int>(shape.anchor), 0), shape.words);
}

QImage Drawing::image(double pixelsPerUnit) const
{
    QImage image((size_ * pixelsPerUnit).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelsPerUnit);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Shape& shape : shapes_)
        paint(painter, shape);
    return image;
}

Result<std::vector<std::filesystem::path>> writeDrawing(const std::filesystem::path& file, const Drawing& drawing)
{
    std::filesystem::path png = file, svg = file;
    png += ".png";
    svg += ".svg";
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !drawing.image(2).save(&buffer, "PNG"))
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory to draw '" + png.string() + "'. Close other programs."};
    for (const Status& written : {writeWholeFile(png, contentOf(bytes)), writeWholeFile(svg, contentOf(drawing.svg()))})
        if (!written)
            return written.error();
    return std::vector{png, svg};
}

} // namespace tetra
