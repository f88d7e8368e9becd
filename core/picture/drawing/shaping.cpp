// SPDX-License-Identifier: GPL-3.0-or-later
// The steps are those of every program that sets text (UAX 9, UAX 24): which characters belong together and by which
// font they are written, what is read from right to left, runs that are alike in all of this, each run's glyphs.
#include "core/picture/drawing/shaping.h"

#include "core/base/text.h"

#include <fribidi.h>

#include <algorithm>
#include <memory>
#include <string>

namespace tetra {
namespace {

/// Control characters have no place in a line.
std::u32string charactersOf(std::string_view text)
{
    std::u32string characters;
    while (!text.empty()) {
        const TextCharacter next = firstCharacter(text);
        characters.push_back(next.code < 0x20 ? U' ' : static_cast<char32_t>(next.code));
        text.remove_prefix(next.bytes);
    }
    return characters;
}

hb_unicode_general_category_t categoryOf(char32_t character)
{
    return hb_unicode_general_category(hb_unicode_funcs_get_default(), character);
}

/// Whether it is written onto or into the letter before it.
bool isAttached(char32_t character)
{
    switch (categoryOf(character)) {
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_FORMAT: return true;
    default: return false;
    }
}

/// By which font each character is written. A letter and what is attached to it are of one font, if one has all; signs
/// without a shape need none.
std::vector<FontFile*> fontsOf(FontFamily& family, const std::u32string& text)
{
    std::vector<FontFile*> fonts(text.size(), &family.first());
    for (std::size_t from = 0, to = 0; from < text.size(); from = to) {
        std::u32string needed(1, text[from]);
        for (to = from + 1; to < text.size() && isAttached(text[to]); ++to)
            if (categoryOf(text[to]) != HB_UNICODE_GENERAL_CATEGORY_FORMAT)
                needed.push_back(text[to]);
        FontFile* font = family.fontWith(needed);
        if (font == nullptr && needed.size() > 1)
            font = family.fontWith(std::span(needed).first(1));
        if (font != nullptr)
            std::fill(fonts.begin() + static_cast<std::ptrdiff_t>(from),
                      fonts.begin() + static_cast<std::ptrdiff_t>(to), font);
    }
    return fonts;
}

/// Even from left to right, odd from right to left; deeper inside the larger.
std::vector<FriBidiLevel> levelsOf(const std::u32string& text)
{
    static_assert(sizeof(FriBidiChar) == sizeof(char32_t));
    const auto* characters = reinterpret_cast<const FriBidiChar*>(text.data());
    const auto length = static_cast<FriBidiStrIndex>(text.size());
    std::vector<FriBidiCharType> types(text.size());
    std::vector<FriBidiBracketType> brackets(text.size());
    std::vector<FriBidiLevel> levels(text.size(), 0);
    FriBidiParType direction = FRIBIDI_PAR_ON; // by the first letter that has one
    fribidi_get_bidi_types(characters, length, types.data());
    fribidi_get_bracket_types(characters, length, types.data(), brackets.data());
    if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), length, &direction, levels.data()) == 0)
        std::ranges::fill(levels, FriBidiLevel{0}); // not enough memory
    return levels;
}

/// Signs that all scripts share are of the script before them, or of the first one.
std::vector<hb_script_t> scriptsOf(const std::u32string& text)
{
    const auto isOne = [](hb_script_t script) {
        return script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED && script != HB_SCRIPT_UNKNOWN;
    };
    std::vector<hb_script_t> scripts;
    for (const char32_t character : text)
        scripts.push_back(hb_unicode_script(hb_unicode_funcs_get_default(), character));
    const auto first = std::ranges::find_if(scripts, isOne);
    hb_script_t last = first != scripts.end() ? *first : HB_SCRIPT_LATIN;
    for (hb_script_t& script : scripts)
        last = script = isOne(script) ? script : last;
    return scripts;
}

struct Run {
    std::size_t from = 0;
    std::size_t to = 0;
    FriBidiLevel level = 0;
    hb_script_t script = HB_SCRIPT_LATIN;
    FontFile* font = nullptr;
};

std::vector<Run> runsOf(FontFamily& family, const std::u32string& text)
{
    const auto fonts = fontsOf(family, text);
    const auto levels = levelsOf(text);
    const auto scripts = scriptsOf(text);
    std::vector<Run> runs;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const Run one{i, i + 1, levels[i], scripts[i], fonts[i]};
        if (!runs.empty() && runs.back().level == one.level && runs.back().script == one.script &&
            runs.back().font == one.font)
            runs.back().to = i + 1;
        else
            runs.push_back(one);
    }
    return runs;
}

/// From the order in which they are read to that from left to right: rule L2 of UAX 9.
void orderAsSeen(std::vector<Run>& runs)
{
    FriBidiLevel deepest = 0;
    for (const Run& run : runs)
        deepest = std::max(deepest, run.level);
    for (FriBidiLevel level = deepest; level > 0; --level)
        for (auto from = runs.begin(); from != runs.end();) {
            from = std::find_if(from, runs.end(), [&](const Run& run) { return run.level >= level; });
            const auto to = std::find_if(from, runs.end(), [&](const Run& run) { return run.level < level; });
            std::reverse(from, to);
            from = to;
        }
}

void addRun(ShapedText& shaped, const Run& run, double pixels, hb_buffer_t* buffer)
{
    const std::u32string& text = shaped.characters;
    hb_buffer_clear_contents(buffer);
    hb_buffer_add_utf32(buffer, reinterpret_cast<const std::uint32_t*>(text.data()), static_cast<int>(text.size()),
                        static_cast<unsigned>(run.from), static_cast<int>(run.to - run.from));
    hb_buffer_set_direction(buffer, run.level % 2 != 0 ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, run.script);
    run.font->setSize(pixels);
    hb_shape(run.font->shaper(), buffer, nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer, &count);
    shaped.runs.push_back({run.from, run.to, shaped.glyphs.size(), shaped.glyphs.size() + count, run.level % 2 != 0});
    for (unsigned i = 0; i < count; ++i) {
        shaped.glyphs.push_back({run.font, infos[i].codepoint, shaped.advance + places[i].x_offset / outlineUnits,
                                 -places[i].y_offset / outlineUnits, infos[i].cluster});
        shaped.advance += places[i].x_advance / outlineUnits;
    }
}

} // namespace

ShapedText shaped(FontFamily& family, std::string_view text, double pixels)
{
    ShapedText result;
    result.characters = charactersOf(text);
    if (result.characters.empty())
        return result;
    auto runs = runsOf(family, result.characters);
    orderAsSeen(runs);
    const std::unique_ptr<hb_buffer_t, ClosedBy<hb_buffer_destroy>> buffer(hb_buffer_create());
    for (const Run& run : runs)
        addRun(result, run, pixels, buffer.get());
    return result;
}

} // namespace tetra
