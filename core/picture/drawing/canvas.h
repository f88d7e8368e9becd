// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/pixels.h"
#include "core/picture/drawing/rectangle.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

struct FT_LibraryRec_;

namespace tetra {

struct FilledPath;
struct StrokedPath;
struct ColourColumn;
struct WrittenText;
using DrawnShape = std::variant<FilledPath, StrokedPath, ColourColumn, WrittenText>;

/// What is painted with: 8-bit sRGB. Alpha 255 covers what was there.
struct PixelInk {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;
    bool operator==(const PixelInk&) const = default;
};

/// `opacity` from 0 to 1; what lies beyond, and colours beyond, count as the end.
PixelInk inkOf(const Colour& colour, double opacity = 1);

/// A closed line of straight pieces and cubic curves: each curve has two controls between its ends. Its last point is
/// joined with its first.
struct PathPoint {
    Eigen::Vector2d place{0, 0};
    bool isControl = false;
};
using Path = std::vector<PathPoint>;

Path polygonPath(std::span<const Eigen::Vector2d> corners);
Path rectanglePath(const Rectangle& rectangle);
/// The ellipse that touches the rectangle's sides.
Path ellipsePath(const Rectangle& rectangle);

enum class LineEnd { Flat, Square };

/// Pixels to paint on, in units that are `scale` pixels long. A pixel of which a part is covered takes that part of
/// the ink, in 255 steps; curves are painted as straight pieces that leave them by a tenth of a pixel at most. What
/// lies outside is left away. Or a drawing, which keeps what is painted as it is (vector_drawing.h). For one thread at
/// a time; the pixels or the drawing outlive it.
class PixelCanvas {
public:
    PixelCanvas(const PixelView& pixels, double scale);
    /// A drawing over a picture of so many pixels.
    PixelCanvas(std::vector<DrawnShape>& drawing, int width, int height, double scale);

    /// Without any if this is a drawing, but as wide and high.
    const PixelView& pixels() const noexcept { return pixels_; }
    double scale() const noexcept { return scale_; }
    Size size() const noexcept { return {pixels_.width / scale_, pixels_.height / scale_}; }
    /// Null unless this is one.
    std::vector<DrawnShape>* drawing() const noexcept { return drawing_; }
    /// FreeType's, which knows the shapes.
    FT_LibraryRec_* library() const noexcept { return library_.get(); }

private:
    struct Closing {
        void operator()(FT_LibraryRec_* library) const noexcept;
    };
    PixelView pixels_;
    double scale_;
    std::vector<DrawnShape>* drawing_ = nullptr;
    std::unique_ptr<FT_LibraryRec_, Closing> library_;
};

/// O(pixels in it).
void fill(const PixelCanvas& canvas, const Rectangle& rectangle, const PixelInk& ink);
/// What the path winds around.
void fill(const PixelCanvas& canvas, const Path& path, const PixelInk& ink);
/// A line along the path, half of it on either side, with bevelled corners.
void stroke(const PixelCanvas& canvas, const Path& path, double width, const PixelInk& ink);
/// The same along straight pieces that do not return to where they begin; at most 8,000 points.
void strokeOpen(const PixelCanvas& canvas, std::span<const Eigen::Vector2d> points, double width, const PixelInk& ink,
                LineEnd end = LineEnd::Flat);
void strokeLine(const PixelCanvas& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
                const PixelInk& ink, LineEnd end = LineEnd::Flat);
/// What the path winds around becomes another picture, whose upper left pixel lies at (left, top), in pixels; as far as
/// that reaches. Of pixels only.
void replaceWithin(const PixelCanvas& canvas, const Path& path, const Picture& content, int left, int top);

} // namespace tetra
