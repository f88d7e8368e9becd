// SPDX-License-Identifier: GPL-3.0-or-later
// PDF by cairo, which opens the fonts anew, by the names of their files, and writes the letters that are used.
#include "core/picture/drawing/pdf_page.h"

#include "core/picture/drawing/font_files.h"

#include <cstdint>
#include <memory>
#include <new>

#include <cairo-ft.h>
#include <cairo-pdf.h>

namespace tetra {
namespace {

constexpr double pointsPerInch = 72;

using CairoSurface = std::unique_ptr<cairo_surface_t, ClosedBy<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, ClosedBy<cairo_destroy>>;
using CairoGradient = std::unique_ptr<cairo_pattern_t, ClosedBy<cairo_pattern_destroy>>;
using FontFace = std::unique_ptr<cairo_font_face_t, ClosedBy<cairo_font_face_destroy>>;

cairo_status_t appendBytes(void* target, const unsigned char* data, unsigned size)
try {
    auto& bytes = *static_cast<std::vector<std::byte>*>(target);
    const auto* const first = reinterpret_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
    return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
}

/// As cairo has pixels: one number each, and colours that are multiplied by their opacity.
std::vector<std::uint32_t> pixelsOf(const Picture& picture, bool transparent)
{
    std::vector<std::uint32_t> pixels;
    pixels.reserve(picture.pixels.size());
    for (const auto& [red, green, blue, alpha] : picture.pixels) {
        const std::uint32_t opacity = transparent ? alpha : 255;
        const auto part = [opacity](std::uint32_t channel) { return (channel * opacity + 127) / 255; };
        pixels.push_back(opacity << 24 | part(red) << 16 | part(green) << 8 | part(blue));
    }
    return pixels;
}

void paintPicture(cairo_t* page, std::vector<std::uint32_t>& pixels, const Picture& picture, bool transparent)
{
    const CairoSurface image(cairo_image_surface_create_for_data(
        reinterpret_cast<unsigned char*>(pixels.data()), transparent ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
        picture.width, picture.height, picture.width * static_cast<int>(sizeof(std::uint32_t))));
    cairo_set_source_surface(page, image.get(), 0, 0);
    cairo_paint(page);
}

void takeInk(cairo_t* page, const PixelInk& ink)
{
    cairo_set_source_rgba(page, ink.red / 255.0, ink.green / 255.0, ink.blue / 255.0, ink.alpha / 255.0);
}

/// Each curve has two controls between its ends; the last one may end where the path begins.
void trace(cairo_t* page, const Path& path, bool closed)
{
    if (path.empty())
        return;
    cairo_new_path(page);
    cairo_move_to(page, path[0].place.x(), path[0].place.y());
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (!path[i].isControl || i + 1 >= path.size()) {
            cairo_line_to(page, path[i].place.x(), path[i].place.y());
            continue;
        }
        const Eigen::Vector2d &first = path[i].place, &second = path[i + 1].place;
        const Eigen::Vector2d& end = path[(i + 2) % path.size()].place;
        cairo_curve_to(page, first.x(), first.y(), second.x(), second.y(), end.x(), end.y());
        i += 2;
    }
    if (closed)
        cairo_close_path(page);
}

void draw(cairo_t* page, const FilledPath& shape)
{
    takeInk(page, shape.ink);
    trace(page, shape.path, true);
    cairo_fill(page);
}

void draw(cairo_t* page, const StrokedPath& shape)
{
    takeInk(page, shape.ink);
    trace(page, shape.path, shape.closed);
    cairo_set_line_width(page, shape.width);
    cairo_set_line_join(page, CAIRO_LINE_JOIN_BEVEL);
    cairo_set_line_cap(page, shape.end == LineEnd::Flat ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_SQUARE);
    cairo_stroke(page);
}

void draw(cairo_t* page, const ColourColumn& column)
{
    const Rectangle& place = column.place;
    const CairoGradient colours(cairo_pattern_create_linear(0, place.top, 0, place.bottom()));
    for (std::size_t row = 0; row < column.rows.size(); ++row) {
        const auto& [red, green, blue, alpha] = column.rows[row];
        const double share = (static_cast<double>(row) + 0.5) / static_cast<double>(column.rows.size());
        cairo_pattern_add_color_stop_rgba(colours.get(), share, red / 255.0, green / 255.0, blue / 255.0,
                                          alpha / 255.0);
    }
    cairo_set_source(page, colours.get());
    cairo_rectangle(page, place.left, place.top, place.width, place.height);
    cairo_fill(page);
}

FontFace openFace(const FontSource& font)
{
    const Pattern pattern(FcPatternCreate());
    if (!pattern)
        throw std::bad_alloc();
    FcPatternAddString(pattern.get(), FC_FILE, reinterpret_cast<const FcChar8*>(font.file.c_str()));
    FcPatternAddInteger(pattern.get(), FC_INDEX, font.index);
    if (!font.variations.empty())
        FcPatternAddString(pattern.get(), FC_FONT_VARIATIONS,
                           reinterpret_cast<const FcChar8*>(font.variations.c_str()));
    if (font.thickened)
        FcPatternAddBool(pattern.get(), FC_EMBOLDEN, FcTrue);
    return FontFace(cairo_ft_font_face_create_for_pattern(pattern.get()));
}

void takeFont(cairo_t* page, const GlyphRun& run)
{
    const FontFace face = openFace(run.font);
    cairo_set_font_face(page, face.get());
    cairo_set_font_size(page, run.size);
}

std::vector<cairo_glyph_t> glyphsOf(const GlyphRun& run)
{
    std::vector<cairo_glyph_t> glyphs;
    for (const GlyphRun::Glyph& glyph : run.glyphs)
        glyphs.push_back({glyph.id, glyph.place.x(), glyph.place.y()});
    return glyphs;
}

/// The rims of all letters are one line, so that they are equally dark where they meet.
void drawRim(cairo_t* page, const WrittenText& text)
{
    cairo_new_path(page);
    for (const GlyphRun& run : text.runs) {
        takeFont(page, run);
        const auto glyphs = glyphsOf(run);
        cairo_glyph_path(page, glyphs.data(), static_cast<int>(glyphs.size()));
    }
    takeInk(page, text.rimInk);
    cairo_set_line_width(page, text.rimWidth);
    cairo_set_line_join(page, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(page);
}

void draw(cairo_t* page, const WrittenText& text)
{
    if (text.rimWidth > 0)
        drawRim(page, text);
    takeInk(page, text.ink);
    for (const GlyphRun& run : text.runs) {
        takeFont(page, run);
        const auto glyphs = glyphsOf(run);
        std::vector<cairo_text_cluster_t> clusters;
        for (const GlyphRun::Cluster& cluster : run.clusters)
            clusters.push_back({cluster.bytes, cluster.glyphs});
        cairo_show_text_glyphs(page, run.text.data(), static_cast<int>(run.text.size()), glyphs.data(),
                               static_cast<int>(glyphs.size()), clusters.data(), static_cast<int>(clusters.size()),
                               run.backward ? CAIRO_TEXT_CLUSTER_FLAG_BACKWARD : cairo_text_cluster_flags_t{});
    }
}

void say(cairo_surface_t* file, cairo_pdf_metadata_t what, const std::string& text)
{
    if (!text.empty())
        cairo_pdf_surface_set_metadata(file, what, text.c_str());
}

Error pdfNeedsMemory()
{
    return {ErrorKind::OutOfResource, Message::say("There is not enough memory for a picture of this size.")};
}

} // namespace

bool writesPdf()
{
    return true;
}

Result<std::vector<std::byte>> pdfOf(const Picture& picture, const VectorDrawing& drawing, const PdfFacts& facts)
try {
    std::vector<std::byte> bytes;
    std::vector<std::uint32_t> pixels = pixelsOf(picture, facts.transparent); // until the file is finished
    const double points = pointsPerInch / facts.pixelsPerInch;
    const CairoSurface file(
        cairo_pdf_surface_create_for_stream(&appendBytes, &bytes, picture.width * points, picture.height * points));
    say(file.get(), CAIRO_PDF_METADATA_TITLE, facts.title);
    say(file.get(), CAIRO_PDF_METADATA_SUBJECT, facts.subject);
    say(file.get(), CAIRO_PDF_METADATA_CREATOR, facts.creator);
    say(file.get(), CAIRO_PDF_METADATA_KEYWORDS, facts.keywords);
    const CairoContext page(cairo_create(file.get()));
    cairo_scale(page.get(), points, points);
    paintPicture(page.get(), pixels, picture, facts.transparent);
    cairo_scale(page.get(), facts.pixelsPerUnit, facts.pixelsPerUnit);
    for (const DrawnShape& shape : drawing)
        std::visit([&](const auto& drawn) { draw(page.get(), drawn); }, shape);
    cairo_show_page(page.get());
    cairo_surface_finish(file.get());
    for (const cairo_status_t status : {cairo_status(page.get()), cairo_surface_status(file.get())})
        if (status == CAIRO_STATUS_NO_MEMORY)
            return pdfNeedsMemory();
        else if (status != CAIRO_STATUS_SUCCESS)
            return Error{ErrorKind::OutOfResource, Message::say("The picture cannot be written as a PDF file: %1.",
                                                                cairo_status_to_string(status))};
    return bytes;
} catch (const std::bad_alloc&) {
    return pdfNeedsMemory();
}

} // namespace tetra
