// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/view/lens.h"
#include "ui/annotations/annotation_content.h"

#include <tan/view.h>

#include <QImage>
#include <QSizeF>

class QPainter;

namespace tetra {

/// Paints them over a picture of this size, in the painter's units; colours and hollows are legible on any background,
/// as texts and lines have a rim. Any thread.
void paintAnnotations(QPainter& painter, const AnnotationContent& content, QSizeF picture);

/// The same over an image, `scale` times as large as in a view of one pixel a unit.
void paintAnnotations(QImage& image, const AnnotationContent& content, double scale);

/// What is seen in a lens.
struct DrawnLens {
    LensState::Shape shape = LensState::Shape::Circle;
    LensPicture place{};
    QImage content{};           ///< of place.part; null: the rim alone
    std::size_t tetrahedra = 0; ///< of its mesh
};

/// Paints a lens over a picture, with a rim and its magnification, in place of what was there. The painter's units are
/// the picture's pixels; lines and text are `scale` times as large as in a view of one pixel a unit. Any thread.
void paintLens(QPainter& painter, const DrawnLens& lens, const Colour& background, double scale);

/// How many pixels of a picture a unit of the view is, so that its annotations take as much of it as they do of the
/// view; not so few that texts could not be read.
double annotationScale(QSize picture, QSize view);

} // namespace tetra
