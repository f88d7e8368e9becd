// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/drawing/canvas.h"

#include "core/picture/drawing/blending.h"
#include "core/picture/drawing/outlines.h"
#include "core/picture/drawing/vector_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

namespace tetra {
namespace {

FT_Vector scaledPoint(const Eigen::Vector2d& place, double scale)
{
    return {std::lround(place.x() * scale * outlineUnits), std::lround(place.y() * scale * outlineUnits)};
}

KeptOutline outlineOf(const Path& path, double scale)
{
    KeptOutline outline;
    for (const PathPoint& point : path) {
        outline.points.push_back(scaledPoint(point.place, scale));
        outline.tags.push_back(point.isControl ? FT_CURVE_TAG_CUBIC : FT_CURVE_TAG_ON);
    }
    if (!path.empty())
        outline.ends.push_back(static_cast<KeptOutline::Index>(path.size() - 1));
    return outline;
}

CoverageBounds boundsOf(const PixelView& pixels)
{
    return {pixels.width, pixels.height};
}

void fillOutline(const PixelCanvas& canvas, KeptOutline outline, const PixelInk& ink)
{
    rasterise(canvas.library(), outline.view(), boundsOf(canvas.pixels()),
              [&](int x, int y, int length, unsigned coverage) {
                  auto* pixel = canvas.pixels().row(y) + x;
                  for (int i = 0; i < length; ++i)
                      blend(pixel[i], ink, coverage);
              });
}

std::uint8_t byteOf(double share)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

/// How much of the pixels from `first` on lies between two places of a line, in 255 parts.
struct LineCoverage {
    int first = 0;
    std::vector<double> shares;
};

LineCoverage coverageOf(double from, double to, int size)
{
    const double begin = std::clamp(from, 0.0, double(size)), end = std::clamp(to, 0.0, double(size));
    LineCoverage coverage{static_cast<int>(begin), {}};
    for (int pixel = coverage.first; pixel < end; ++pixel)
        coverage.shares.push_back(std::min(end, pixel + 1.0) - std::max(begin, double(pixel)));
    return coverage;
}

} // namespace

PixelInk inkOf(const Colour& colour, double opacity)
{
    return {byteOf(colour.red), byteOf(colour.green), byteOf(colour.blue), byteOf(opacity)};
}

Path polygonPath(std::span<const Eigen::Vector2d> corners)
{
    Path path;
    for (const Eigen::Vector2d& corner : corners)
        path.push_back({corner});
    return path;
}

Path rectanglePath(const Rectangle& rectangle)
{
    return {{{rectangle.left, rectangle.top}},
            {{rectangle.right(), rectangle.top}},
            {{rectangle.right(), rectangle.bottom()}},
            {{rectangle.left, rectangle.bottom()}}};
}

Path ellipsePath(const Rectangle& rectangle)
{
    const Eigen::Vector2d middle = rectangle.centre();
    const Eigen::Vector2d right(rectangle.width / 2, 0), down(0, rectangle.height / 2);
    const double handle = 4 * (std::sqrt(2.0) - 1) / 3; // of a quarter: its middle lies on the ellipse
    Path path;
    const auto quarter = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        path.push_back({middle + from});
        path.push_back({middle + from + handle * to, true});
        path.push_back({middle + to + handle * from, true});
    };
    quarter(right, down);
    quarter(down, -right);
    quarter(-right, -down);
    quarter(-down, right);
    return path;
}

PixelCanvas::PixelCanvas(std::vector<DrawnShape>& drawing, int width, int height, double scale)
    : PixelCanvas(PixelView{{}, width, height}, scale)
{
    drawing_ = &drawing;
}

PixelCanvas::PixelCanvas(const PixelView& pixels, double scale) : pixels_(pixels), scale_(scale)
{
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0)
        throw std::bad_alloc(); // the only reason that it has
    library_.reset(library);
}

void PixelCanvas::Closing::operator()(FT_LibraryRec_* library) const noexcept
{
    FT_Done_FreeType(library);
}

void fill(const PixelCanvas& canvas, const Rectangle& rectangle, const PixelInk& ink)
{
    if (canvas.drawing() != nullptr)
        return fill(canvas, rectanglePath(rectangle), ink);
    const PixelView& pixels = canvas.pixels();
    const double scale = canvas.scale();
    const LineCoverage across = coverageOf(rectangle.left * scale, rectangle.right() * scale, pixels.width);
    const LineCoverage down = coverageOf(rectangle.top * scale, rectangle.bottom() * scale, pixels.height);
    for (std::size_t y = 0; y < down.shares.size(); ++y) {
        auto* row = pixels.row(down.first + static_cast<int>(y)) + across.first;
        for (std::size_t x = 0; x < across.shares.size(); ++x)
            blend(row[x], ink, static_cast<unsigned>(std::lround(255 * down.shares[y] * across.shares[x])));
    }
}

void fill(const PixelCanvas& canvas, const Path& path, const PixelInk& ink)
{
    if (canvas.drawing() != nullptr)
        return canvas.drawing()->push_back(FilledPath{path, ink});
    fillOutline(canvas, outlineOf(path, canvas.scale()), ink);
}

void stroke(const PixelCanvas& canvas, const Path& path, double width, const PixelInk& ink)
{
    if (canvas.drawing() != nullptr)
        return canvas.drawing()->push_back(StrokedPath{path, true, width, ink});
    const Stroker stroker =
        strokerOf(canvas.library(), width * canvas.scale(), FT_STROKER_LINECAP_BUTT, FT_STROKER_LINEJOIN_BEVEL);
    if (stroker)
        fillOutline(canvas, strokeOf(stroker.get(), outlineOf(path, canvas.scale()).view(), false), ink);
}

void strokeOpen(const PixelCanvas& canvas, std::span<const Eigen::Vector2d> points, double width, const PixelInk& ink,
                LineEnd end)
{
    if (canvas.drawing() != nullptr)
        return canvas.drawing()->push_back(StrokedPath{polygonPath(points), false, width, ink, end});
    const Stroker stroker = strokerOf(canvas.library(), width * canvas.scale(),
                                      end == LineEnd::Flat ? FT_STROKER_LINECAP_BUTT : FT_STROKER_LINECAP_SQUARE,
                                      FT_STROKER_LINEJOIN_BEVEL);
    if (stroker)
        fillOutline(canvas, strokeOf(stroker.get(), outlineOf(polygonPath(points), canvas.scale()).view(), true), ink);
}

void strokeLine(const PixelCanvas& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
                const PixelInk& ink, LineEnd end)
{
    strokeOpen(canvas, std::array{from, to}, width, ink, end);
}

void replaceWithin(const PixelCanvas& canvas, const Path& path, const Picture& content, int left, int top)
{
    KeptOutline outline = outlineOf(path, canvas.scale());
    rasterise(canvas.library(), outline.view(), boundsOf(canvas.pixels()),
              [&](int x, int y, int length, unsigned coverage) {
                  const int row = y - top;
                  if (row < 0 || row >= content.height)
                      return;
                  auto* pixel = canvas.pixels().row(y);
                  const auto* source = content.pixels.data() + static_cast<std::size_t>(row) * content.width;
                  for (int at = std::max(x, left); at < std::min(x + length, left + content.width); ++at)
                      mix(pixel[at], source[at - left], coverage);
              });
}

} // namespace tetra
