// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/fonts.h"
#include "core/picture/drawing/outlines.h"
#include "core/picture/drawing/vector_drawing.h"

#include <fontconfig/fontconfig.h>
#include <hb.h>

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>

namespace tetra {

// The files of fonts, for those that shape and paint texts. Null pointers are what was not found.

template <auto close> struct ClosedBy {
    template <class Opened> void operator()(Opened* opened) const noexcept { close(opened); }
};
using Pattern = std::unique_ptr<FcPattern, ClosedBy<FcPatternDestroy>>;
using FontList = std::unique_ptr<FcFontSet, ClosedBy<FcFontSetDestroy>>;
using Configuration = std::unique_ptr<FcConfig, ClosedBy<FcConfigDestroy>>;
using FreeType = std::unique_ptr<FT_LibraryRec_, ClosedBy<FT_Done_FreeType>>;

/// One font of one file.
class FontFile {
public:
    /// `found`: a font that is prepared to be opened (FcFontRenderPrepare). Null if it cannot be, or has no outlines.
    static std::unique_ptr<FontFile> open(FT_Library library, FcPattern* found);

    /// Its letters are so many pixels large from now on.
    void setSize(double pixels);
    hb_font_t* shaper() const noexcept { return shaper_.get(); }
    double ascent(double pixels) const noexcept;
    double descent(double pixels) const noexcept;
    const FontSource& source() const noexcept { return source_; }
    /// Of a glyph, with the origin of the letter at 0, 0 and y down; valid until the next one. Empty, for spaces and
    /// for what is damaged.
    FT_Outline outlineOf(unsigned glyph);

private:
    using Face = std::unique_ptr<FT_FaceRec_, ClosedBy<FT_Done_Face>>;
    using Shaper = std::unique_ptr<hb_font_t, ClosedBy<hb_font_destroy>>;

    FontFile(Face face, FontSource source) : face_(std::move(face)), source_(std::move(source)) {}
    void vary();

    Face face_;
    Shaper shaper_{};
    double pixels_ = 0;
    FontSource source_;
};

/// The fonts that stand for a family in one weight, the nearest first.
class FontFamily {
public:
    /// Not usable if this system has no font with outlines.
    FontFamily(FT_Library library, FcConfig* configuration, const std::string& name, bool bold);

    bool isUsable() const noexcept { return first_ != nullptr; }
    FontFile& first() const noexcept { return *first_; }
    /// The nearest that has all these characters; null if none has.
    FontFile* fontWith(std::span<const char32_t> characters);

private:
    FontFile* opened(FcPattern* listed);
    const FcFontSet* others();

    FT_Library library_;
    FcConfig* configuration_;
    Pattern wanted_;
    Pattern firstFound_;
    std::unique_ptr<FontFile> first_;
    FontList others_{}; ///< found when a character is first missing, as that takes long
    std::map<const FcPattern*, std::unique_ptr<FontFile>> opened_{};
};

/// One thread at a time: `turn` is held by whoever uses it.
class Fonts {
public:
    explicit Fonts(const std::string& family);

    bool isUsable() const noexcept { return regular_ && regular_->isUsable() && bold_->isUsable(); }
    FontFamily& family(bool bold) const noexcept { return bold ? *bold_ : *regular_; }

    mutable std::mutex turn{};

private:
    FreeType library_{};
    Configuration configuration_{};
    std::unique_ptr<FontFamily> regular_{};
    std::unique_ptr<FontFamily> bold_{};
};

} // namespace tetra
