// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_content.h"
#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/pixels.h"

#include <tan/base.h>

namespace tetra {

/// Paints them over a picture, `scale` times as large as in a view of one pixel a unit; colours and hollows are legible
/// on any background, as texts and lines have a rim. Nothing else is touched. Any thread. Errors: those of openFonts(),
/// if the content has none and something is shown; the picture is as it was then.
Status paintAnnotations(const PixelView& picture, const AnnotationContent& content, double scale);

/// The same onto a canvas, which may be a drawing.
Status paintAnnotations(const PixelCanvas& canvas, const AnnotationContent& content);

/// How many pixels of a picture a unit of the view is, so that its annotations take as much of it as they do of the
/// view; not so few that texts could not be read. Sizes are widths and heights.
double annotationScale(const Eigen::Vector2i& picture, const Eigen::Vector2i& view);

} // namespace tetra
