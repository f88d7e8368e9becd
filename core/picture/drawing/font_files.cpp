// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/drawing/font_files.h"

#include <hb-ft.h>

#include FT_MULTIPLE_MASTERS_H

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <new>
#include <string_view>
#include <vector>

namespace tetra {
namespace {

std::string textOf(const FcPattern* pattern, const char* property)
{
    FcChar8* text = nullptr;
    return FcPatternGetString(pattern, property, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

bool isSet(const FcPattern* pattern, const char* property)
{
    FcBool set = FcFalse;
    return FcPatternGetBool(pattern, property, 0, &set) == FcResultMatch && set != FcFalse;
}

/// Pictures of letters, such as those in colours, are none.
bool hasOutlines(const FcPattern* pattern)
{
    return isSet(pattern, FC_OUTLINE) && !isSet(pattern, FC_COLOR);
}

/// What fontconfig is asked for.
Pattern patternOf(FcConfig* configuration, const std::string& family, bool bold)
{
    Pattern pattern(FcPatternCreate());
    if (!pattern)
        throw std::bad_alloc();
    if (!family.empty())
        FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
    FcPatternAddInteger(pattern.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
    FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
    FcConfigSubstitute(configuration, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    return pattern;
}

bool hasAll(const FcPattern* font, std::span<const char32_t> characters)
{
    FcCharSet* has = nullptr;
    return FcPatternGetCharSet(font, FC_CHARSET, 0, &has) == FcResultMatch &&
           std::ranges::all_of(characters, [&](char32_t one) { return FcCharSetHasChar(has, one) != FcFalse; });
}

} // namespace

std::unique_ptr<FontFile> FontFile::open(FT_Library library, FcPattern* found)
{
    constexpr unsigned variable = 0x8000; // fontconfig's number for all variations together
    int index = 0;
    FcPatternGetInteger(found, FC_INDEX, 0, &index);
    if (static_cast<unsigned>(index) >> 16 == variable)
        index &= 0xffff;
    FT_Face opened = nullptr;
    FontSource source{textOf(found, FC_FILE), index, textOf(found, FC_FONT_VARIATIONS), isSet(found, FC_EMBOLDEN)};
    if (!hasOutlines(found) || FT_New_Face(library, source.file.c_str(), index, &opened) != 0)
        return nullptr;
    Face face(opened);
    if (!FT_IS_SCALABLE(opened))
        return nullptr;
    std::unique_ptr<FontFile> font(new FontFile(std::move(face), std::move(source)));
    font->vary();
    font->setSize(12);
    font->shaper_.reset(hb_ft_font_create_referenced(opened));
    hb_ft_font_set_load_flags(font->shaper_.get(), FT_LOAD_NO_HINTING); // as wide in every size
    return font;
}

void FontFile::vary()
{
    const std::string& variations = source_.variations;
    FT_MM_Var* axes = nullptr;
    if (variations.empty() || FT_Get_MM_Var(face_.get(), &axes) != 0)
        return;
    std::vector<FT_Fixed> places(axes->num_axis);
    for (FT_UInt i = 0; i < axes->num_axis; ++i) {
        const FT_ULong tag = axes->axis[i].tag;
        const std::array name{static_cast<char>(tag >> 24), static_cast<char>(tag >> 16), static_cast<char>(tag >> 8),
                              static_cast<char>(tag), '='};
        places[i] = axes->axis[i].def;
        if (const auto at = variations.find(std::string_view(name.data(), name.size())); at != std::string::npos) {
            double place = 0;
            const char* const number = variations.data() + at + name.size();
            if (std::from_chars(number, variations.data() + variations.size(), place).ec == std::errc())
                places[i] = std::lround(std::clamp(place, -32000.0, 32000.0) * 65536);
        }
    }
    FT_Set_Var_Design_Coordinates(face_.get(), axes->num_axis, places.data());
    FT_Done_MM_Var(face_->glyph->library, axes);
}

void FontFile::setSize(double pixels)
{
    if (pixels == pixels_)
        return;
    pixels_ = pixels;
    FT_Set_Char_Size(face_.get(), 0, std::lround(pixels * outlineUnits), 72, 72);
    if (shaper_)
        hb_ft_font_changed(shaper_.get());
}

double FontFile::ascent(double pixels) const noexcept
{
    return pixels * face_->ascender / face_->units_per_EM;
}

double FontFile::descent(double pixels) const noexcept
{
    return -pixels * face_->descender / face_->units_per_EM;
}

FT_Outline FontFile::outlineOf(unsigned glyph)
{
    if (FT_Load_Glyph(face_.get(), glyph, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT) != 0 ||
        face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
        return {};
    FT_Outline& outline = face_->glyph->outline;
    if (source_.thickened)
        FT_Outline_Embolden(&outline, std::lround(pixels_ * outlineUnits / 24));
    FT_Matrix upsideDown{0x10000, 0, 0, -0x10000};
    FT_Outline_Transform(&outline, &upsideDown);
    return outline;
}

FontFamily::FontFamily(FT_Library library, FcConfig* configuration, const std::string& name, bool bold)
    : library_(library), configuration_(configuration), wanted_(patternOf(configuration, name, bold))
{
    FcResult result = FcResultMatch;
    firstFound_.reset(FcFontMatch(configuration, wanted_.get(), &result));
    if (firstFound_)
        first_ = FontFile::open(library, firstFound_.get());
    if (first_ || !firstFound_)
        return;
    // The nearest has no outlines, or its file is gone.
    const FcFontSet* fonts = others();
    for (int i = 0; fonts != nullptr && i < fonts->nfont && !first_; ++i) {
        firstFound_.reset(FcFontRenderPrepare(configuration, wanted_.get(), fonts->fonts[i]));
        first_ = firstFound_ ? FontFile::open(library, firstFound_.get()) : nullptr;
    }
}

const FcFontSet* FontFamily::others()
{
    FcResult result = FcResultMatch;
    if (!others_)
        others_.reset(FcFontSort(configuration_, wanted_.get(), FcTrue, nullptr, &result));
    return others_.get();
}

FontFile* FontFamily::opened(FcPattern* listed)
{
    const auto [place, isNew] = opened_.try_emplace(listed);
    if (isNew)
        if (const Pattern prepared(FcFontRenderPrepare(configuration_, wanted_.get(), listed)); prepared)
            place->second = FontFile::open(library_, prepared.get());
    return place->second.get();
}

FontFile* FontFamily::fontWith(std::span<const char32_t> characters)
{
    if (hasAll(firstFound_.get(), characters))
        return first_.get();
    const FcFontSet* fonts = others();
    for (int i = 0; fonts != nullptr && i < fonts->nfont; ++i)
        if (hasOutlines(fonts->fonts[i]) && hasAll(fonts->fonts[i], characters))
            if (FontFile* font = opened(fonts->fonts[i]))
                return font;
    return nullptr;
}

Fonts::Fonts(const std::string& family) : configuration_(FcConfigReference(nullptr))
{
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0)
        throw std::bad_alloc();
    library_.reset(library);
    if (!configuration_)
        return;
    regular_ = std::make_unique<FontFamily>(library, configuration_.get(), family, false);
    bold_ = std::make_unique<FontFamily>(library, configuration_.get(), family, true);
}

Result<std::shared_ptr<const Fonts>> openFonts(const std::string& family)
{
    const auto fonts = std::make_shared<const Fonts>(family);
    if (!fonts->isUsable())
        return Error{ErrorKind::OutOfResource,
                     Message::say("This system has no font to write into pictures. Install one, such as the package "
                                  "fonts-dejavu-core of Debian, or take the picture without annotations.")};
    return fonts;
}

} // namespace tetra
