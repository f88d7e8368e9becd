// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"
#include "core/picture/drawing/fonts.h"
#include "core/picture/drawing/pixels.h"
#include "core/view/lens.h"

#include <tan/base.h>
#include <tan/view.h>

#include <memory>

namespace tetra {

/// What is seen in a lens.
struct DrawnLens {
    LensState::Shape shape = LensState::Shape::Circle;
    LensPicture place{};
    Picture content{};          ///< of place.part; without pixels: the rim alone
    std::size_t tetrahedra = 0; ///< of its mesh
};

/// How a lens says how much it magnifies.
struct LensWriting {
    NumberSigns numbers{};
    std::shared_ptr<const Fonts> fonts{}; ///< null: as AnnotationContent::fonts
};

/// Paints a lens over a picture, with a rim and its magnification, in place of what was there; lines and text are
/// `scale` times as large as in a view of one pixel a unit. Any thread. Errors: those of openFonts(); the picture is as
/// it was then.
Status paintLens(const PixelView& picture, const DrawnLens& lens, const Colour& background, double scale,
                 const LensWriting& writing = {});

} // namespace tetra
