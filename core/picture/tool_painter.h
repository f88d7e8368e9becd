// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"
#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/fonts.h"
#include "core/picture/drawing/pixels.h"
#include "plugins/api/tool.h"

#include <tan/base.h>
#include <tan/render.h>

#include <memory>
#include <span>
#include <string>

namespace tetra {

/// How tools are painted over a picture.
struct ToolInk {
    Camera camera{};
    Colour background{}; ///< lines and texts are dark or light after it, with a rim of it
    AnnotationLanguage language{};
    std::shared_ptr<const Fonts> fonts{}; ///< null: the system's sans-serif, opened anew
    std::string selected{};               ///< a handle
    std::string hovered{};                ///< likewise
};

/// Paints what tools show over a picture, `scale` times as large as in a view of one pixel a unit; nothing of what lies
/// behind the eye. The numbers of the drawings are finite, widths and radii positive. Any thread. O(points and pixels
/// painted). Errors: those of openFonts(), if the ink has none and there are texts; the picture is as it was then.
Status paintTools(const PixelView& picture, std::span<const ToolDrawing> drawings, const ToolInk& ink, double scale);
/// The same onto a canvas, which may be a drawing.
Status paintTools(const PixelCanvas& canvas, std::span<const ToolDrawing> drawings, const ToolInk& ink);

} // namespace tetra
