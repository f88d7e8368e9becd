// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/drawing/text.h"

#include "core/picture/drawing/blending.h"
#include "core/picture/drawing/shaping.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

namespace tetra {
namespace {

/// How much of each pixel of a part of a picture is covered by any of several shapes.
class CoverageMask {
public:
    /// Of this part of a picture of so many pixels.
    CoverageMask(const Rectangle& part, int width, int height)
        : left_(static_cast<int>(std::clamp(std::floor(part.left), 0.0, double(width)))),
          top_(static_cast<int>(std::clamp(std::floor(part.top), 0.0, double(height)))),
          width_(static_cast<int>(std::clamp(std::ceil(part.right()), 0.0, double(width))) - left_),
          height_(static_cast<int>(std::clamp(std::ceil(part.bottom()), 0.0, double(height))) - top_),
          covered_(isEmpty() ? 0 : static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))
    {
    }

    bool isEmpty() const noexcept { return width_ <= 0 || height_ <= 0; }

    /// The outline is moved; its points are those of the picture.
    void add(FT_Library library, FT_Outline outline)
    {
        FT_Outline_Translate(&outline, -left_ * FT_Pos{64}, -top_ * FT_Pos{64});
        rasterise(library, outline, {width_, height_}, [this](int x, int y, int length, std::uint8_t coverage) {
            const auto from = covered_.begin() + static_cast<std::ptrdiff_t>(y) * width_ + x;
            std::transform(from, from + length, from, [&](std::uint8_t there) { return std::max(there, coverage); });
        });
    }

    void paint(const PixelView& pixels, const PixelInk& ink) const
    {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
                blend(pixels.row(top_ + y)[left_ + x], ink, covered_[static_cast<std::size_t>(y) * width_ + x]);
    }

private:
    int left_, top_, width_, height_;
    std::vector<std::uint8_t> covered_;
};

} // namespace

TextMetrics measured(const Fonts& fonts, std::string_view text, const TextStyle& style)
{
    const std::lock_guard turn(fonts.turn);
    FontFamily& family = fonts.family(style.bold);
    return {shaped(family, text, style.size).advance, family.first().ascent(style.size),
            family.first().descent(style.size)};
}

void paintText(const PixelCanvas& canvas, const Fonts& fonts, std::string_view text, const TextStyle& style,
               const Eigen::Vector2d& baseline, const PixelInk& ink, const TextRim& rim)
{
    const std::lock_guard turn(fonts.turn);
    const double pixels = style.size * canvas.scale(), rimPixels = rim.width * canvas.scale();
    const ShapedText line = shaped(fonts.family(style.bold), text, pixels);
    const double left = baseline.x() * canvas.scale(), bottom = std::round(baseline.y() * canvas.scale());
    // Marks of some scripts are tall, and letters of some fonts wider than they say.
    const Rectangle part = Rectangle{left, bottom - 2 * pixels, line.advance, 3 * pixels}.grown(pixels + rimPixels);
    CoverageMask letters(part, canvas.pixels().width, canvas.pixels().height), rims = letters;
    if (letters.isEmpty())
        return;
    const Stroker stroker = strokerOf(canvas.library(), rimPixels, FT_STROKER_LINECAP_ROUND, FT_STROKER_LINEJOIN_ROUND);
    for (const PlacedGlyph& placed : line.glyphs) {
        placed.font->setSize(pixels);
        FT_Outline outline = placed.font->outlineOf(placed.glyph);
        FT_Outline_Translate(&outline, std::lround((left + placed.x) * outlineUnits),
                             std::lround((bottom + placed.y) * outlineUnits));
        if (stroker && rim.width > 0)
            rims.add(canvas.library(), strokeOf(stroker.get(), outline, false).view());
        letters.add(canvas.library(), outline);
    }
    rims.paint(canvas.pixels(), rim.ink);
    letters.paint(canvas.pixels(), ink);
}

} // namespace tetra
