// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/drawing.h"

#include "core/base/file_writer.h"
#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/text.h"

#include <tan/picture.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <string_view>

namespace tetra {
namespace {

struct InkColours {
    const char* name;
    std::uint32_t light; ///< on a white ground, 0xrrggbb
    std::uint32_t dark;
};
constexpr std::size_t seriesInks = 8;
constexpr std::array<InkColours, std::size_t(ChartInk::Series) + seriesInks> inks = {{
    {"ground", 0xffffff, 0x1b1e21},
    {"text", 0x1c1e21, 0xe3e6e8},
    {"soft", 0x565c63, 0xa9b1b8},
    {"grid", 0xdfe3e7, 0x33393f},
    {"axis", 0x767d85, 0x8b939b},
    {"s0", 0x0072b2, 0x56b4e9},
    {"s1", 0xd55e00, 0xf08a4b},
    {"s2", 0x6a7178, 0x9aa2aa},
    {"s3", 0x00805d, 0x2fb891},
    {"s4", 0xa8558a, 0xd79cc1},
    {"s5", 0xb07a00, 0xe6b84d},
    {"s6", 0x3a9bd6, 0x8fd0f5},
    {"s7", 0x7a7a1f, 0xcccc66},
}};

const InkColours& coloursOf(ChartInk ink)
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

/// With one decimal.
std::string decimal(double value)
{
    std::array<char, 64> text{}; // coordinates of a drawing are small
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 1);
    return {text.data(), end};
}

/// "#56b4e9"
std::string hexColour(std::uint32_t colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4)
        text += digits[colour >> shift & 15];
    return text;
}

std::string colourRules(std::uint32_t InkColours::*colour)
{
    std::string rules;
    for (const InkColours& ink : inks)
        rules += std::string(".") + ink.name + " { color: " + hexColour(ink.*colour) + "; } ";
    return rules;
}

/// "BEFOREx,yAFTER" for each point.
std::string listOf(const Points& points, const char* before, const char* after)
{
    std::string list;
    for (const Eigen::Vector2d& point : points)
        list += before + decimal(point.x()) + ',' + decimal(point.y()) + after;
    return list;
}

std::string escaped(std::string_view text)
{
    std::string safe;
    for (const char character : text)
        switch (character) {
        case '<': safe += "&lt;"; break;
        case '>': safe += "&gt;"; break;
        case '&': safe += "&amp;"; break;
        case '"': safe += "&quot;"; break;
        default: safe += character;
        }
    return safe;
}

/// name="value" after a blank.
std::string attribute(const char* name, const std::string& value)
{
    return std::string(" ") + name + "=\"" + value + '"';
}

PixelInk lightInk(ChartInk ink)
{
    const std::uint32_t colour = coloursOf(ink).light;
    return {static_cast<std::uint8_t>(colour >> 16), static_cast<std::uint8_t>(colour >> 8 & 0xff),
            static_cast<std::uint8_t>(colour & 0xff)};
}

/// Pieces end beyond their ends, so that none gapes at a corner.
void paintPolyline(const PixelCanvas& canvas, const Points& points, double width, const PixelInk& ink)
{
    const LineEnd end = points.size() > 2 ? LineEnd::Square : LineEnd::Flat;
    for (std::size_t i = 1; i < points.size(); ++i)
        strokeLine(canvas, points[i - 1], points[i], width, ink, end);
}

void paintDots(const PixelCanvas& canvas, const Points& places, double diameter, const PixelInk& ink)
{
    for (const Eigen::Vector2d& place : places)
        fill(canvas, ellipsePath(Rectangle{0, 0, diameter, diameter}.centredAt(place)), ink);
}

void paintWords(const PixelCanvas& canvas, const Fonts& fonts, const std::string& words, Letters letters, Anchor anchor,
                const Eigen::Vector2d& place, const PixelInk& ink)
{
    const TextStyle style{static_cast<double>(styleOf(letters).size), styleOf(letters).isBold};
    const double width = measured(fonts, words, style).advance;
    paintText(canvas, fonts, words, style, place - Eigen::Vector2d(width / 2 * static_cast<int>(anchor), 0), ink, {});
}

} // namespace

Points rectangle(double left, double top, double width, double height)
{
    return {{left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}, {left, top}};
}

ChartInk seriesInk(std::size_t number)
{
    return static_cast<ChartInk>(std::size_t(ChartInk::Series) + number % seriesInks);
}

Drawing::Drawing(const Eigen::Vector2d& size, std::string title, std::string description)
    : size_(size), title_(std::move(title)), description_(std::move(description))
{
    area(rectangle(0, 0, size.x(), size.y()), ChartInk::Ground);
}

void Drawing::text(const Eigen::Vector2d& place, const std::string& words, Letters letters, Anchor anchor)
{
    const ChartInk ink = letters == Letters::Soft ? ChartInk::Soft : ChartInk::Text;
    shapes_.push_back({Kind::Text, {place}, ink, 1, words, letters, anchor});
}

void Drawing::line(const Points& points, ChartInk ink, double width)
{
    shapes_.push_back({Kind::Line, points, ink, width});
}

void Drawing::area(const Points& border, ChartInk ink)
{
    shapes_.push_back({Kind::Area, border, ink});
}

void Drawing::dots(const Points& places, ChartInk ink, double diameter)
{
    shapes_.push_back({Kind::Dots, places, ink, diameter});
}

std::string Drawing::svgOf(const Shape& shape)
{
    const std::string ink = attribute("class", coloursOf(shape.ink).name);
    switch (shape.kind) {
    case Kind::Line:
        return "<polyline" + ink + R"( fill="none" stroke="currentColor")" +
               attribute("stroke-width", decimal(shape.width)) + attribute("points", listOf(shape.points, "", " ")) +
               "/>";
    case Kind::Area:
        return "<polygon" + ink + R"( fill="currentColor")" + attribute("points", listOf(shape.points, "", " ")) + "/>";
    case Kind::Dots:
        return "<path" + ink + R"( stroke="currentColor")" + attribute("stroke-width", decimal(shape.width)) +
               R"( stroke-linecap="round")" + attribute("d", listOf(shape.points, "M", "h0")) + "/>";
    case Kind::Text: break;
    }
    const char* const anchors[] = {"start", "middle", "end"};
    const auto [size, isBold] = styleOf(shape.letters);
    return "<text" + ink + R"( fill="currentColor")" + attribute("font-size", std::to_string(size)) +
           attribute("font-weight", isBold ? "600" : "400") +
           attribute("text-anchor", anchors[std::size_t(shape.anchor)]) + attribute("x", decimal(shape.points[0].x())) +
           attribute("y", decimal(shape.points[0].y())) + '>' + escaped(shape.words) + "</text>";
}

std::string Drawing::svg() const
{
    const std::string width = formatNumber(size_.x()), height = formatNumber(size_.y());
    std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg")" +
                       attribute("viewBox", "0 0 " + width + ' ' + height) + attribute("width", width) +
                       attribute("height", height) + R"( role="img" aria-labelledby="title description">)" +
                       "\n<title id=\"title\">" + escaped(title_) + "</title>\n<desc id=\"description\">" +
                       escaped(description_) + "</desc>\n<style>\ntext { font-family: system-ui, sans-serif; }\n" +
                       colourRules(&InkColours::light) + "\n@media (prefers-color-scheme: dark) { " +
                       colourRules(&InkColours::dark) + "}\n</style>\n";
    for (const Shape& shape : shapes_)
        text += svgOf(shape) + '\n';
    return text + "</svg>\n";
}

Result<Picture> Drawing::picture(double pixelsPerUnit) const
try {
    constexpr std::array<std::uint8_t, 4> white = {255, 255, 255, 255};
    const auto fonts = openFonts();
    if (!fonts)
        return fonts.error();
    Picture picture;
    picture.width = static_cast<int>(std::lround(size_.x() * pixelsPerUnit));
    picture.height = static_cast<int>(std::lround(size_.y() * pixelsPerUnit));
    picture.pixels.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), white);
    const PixelCanvas canvas(pixelsOf(picture), pixelsPerUnit);
    for (const Shape& shape : shapes_) {
        const PixelInk ink = lightInk(shape.ink);
        switch (shape.kind) {
        case Kind::Line: paintPolyline(canvas, shape.points, shape.width, ink); break;
        case Kind::Area: fill(canvas, polygonPath(shape.points), ink); break;
        case Kind::Dots: paintDots(canvas, shape.points, shape.width, ink); break;
        case Kind::Text:
            paintWords(canvas, **fonts, shape.words, shape.letters, shape.anchor, shape.points[0], ink);
            break;
        }
    }
    return picture;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory for a drawing. Close other programs."};
}

Result<std::vector<std::filesystem::path>> writeDrawing(const std::filesystem::path& file, const Drawing& drawing)
{
    std::filesystem::path png = file, svg = file;
    png += ".png";
    svg += ".svg";
    const auto picture = drawing.picture(2);
    if (!picture)
        return picture.error();
    const std::string text = drawing.svg();
    for (const Status& written : {writePicture(*picture, png), writeWholeFile(svg, std::as_bytes(std::span(text)))})
        if (!written)
            return written.error();
    return std::vector{png, svg};
}

} // namespace tetra
