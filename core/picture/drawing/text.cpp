// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/drawing/text.h"

#include "core/picture/drawing/blending.h"
#include "core/picture/drawing/shaping.h"
#include "core/picture/drawing/vector_drawing.h"

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

/// Where the clusters of a run's glyphs begin, in the order of the text.
std::vector<GlyphRun::Cluster> clustersOf(const ShapedText& line, const ShapedRun& run)
{
    std::vector<GlyphRun::Cluster> clusters;
    std::vector<std::size_t> starts; // of the clusters, among the characters
    const std::size_t count = run.endGlyph - run.firstGlyph;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = run.backward ? run.endGlyph - 1 - i : run.firstGlyph + i;
        const std::size_t character = line.glyphs[at].character;
        if (starts.empty() || starts.back() != character) {
            starts.push_back(character);
            clusters.push_back({});
        }
        ++clusters.back().glyphs;
    }
    starts.push_back(run.endCharacter);
    for (std::size_t i = 0; i < clusters.size(); ++i)
        for (std::size_t at = starts[i]; at < starts[i + 1]; ++at)
            clusters[i].bytes += static_cast<int>(utf8Of(line.characters[at]).size());
    return clusters;
}

/// In units; `line` is shaped in letters of `scale` times the size.
GlyphRun glyphRunOf(const ShapedText& line, const ShapedRun& run, const Eigen::Vector2d& baseline, double size,
                    double scale)
{
    GlyphRun written{.size = size, .clusters = clustersOf(line, run), .backward = run.backward};
    for (std::size_t at = run.firstCharacter; at < run.endCharacter; ++at)
        written.text += utf8Of(line.characters[at]);
    for (std::size_t at = run.firstGlyph; at < run.endGlyph; ++at) {
        const PlacedGlyph& placed = line.glyphs[at];
        written.font = placed.font->source();
        written.glyphs.push_back({placed.glyph, baseline + Eigen::Vector2d(placed.x, placed.y) / scale});
    }
    return written;
}

} // namespace

std::string utf8Of(char32_t character)
{
    if (character < 0x80)
        return {static_cast<char>(character)};
    const int following = character < 0x800 ? 1 : character < 0x10000 ? 2 : 3;
    std::string text;
    text += static_cast<char>((0xff00U >> (following + 1) & 0xffU) | character >> (6 * following));
    for (int left = following - 1; left >= 0; --left)
        text += static_cast<char>(0x80U | (character >> (6 * left) & 0x3fU));
    return text;
}

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
    if (canvas.drawing() != nullptr) {
        WrittenText written{{}, ink, rim.width, rim.ink};
        for (const ShapedRun& run : line.runs)
            if (run.endGlyph > run.firstGlyph)
                written.runs.push_back(glyphRunOf(line, run, baseline, style.size, canvas.scale()));
        return canvas.drawing()->push_back(std::move(written));
    }
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
