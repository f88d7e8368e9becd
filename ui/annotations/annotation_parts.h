// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/annotations/annotation_layout.h"

namespace tetra {

/// The annotations one by one: how large they are, and what stands where in the place that they were given. Sizes are
/// null for what has nothing to say.

/// `axis`: barAxisOf() the content, which is worked out once for a layout.
QSizeF colourBarSize(const AnnotationContent& content, const BarAxis& axis, double height, const TextMeasure& measure);
ColourBarLayout layOutColourBar(const AnnotationContent& content, const BarAxis& axis, const QRectF& place,
                                const TextMeasure& measure);

QSizeF axesSize(const TextMeasure& measure);
AxesLayout layOutAxes(const AnnotationContent& content, const QRectF& place, const TextMeasure& measure);

/// For a picture of this size.
QSizeF scaleBarSize(const AnnotationContent& content, QSizeF picture, const TextMeasure& measure);
ScaleBarLayout layOutScaleBar(const AnnotationContent& content, QSizeF picture, const QRectF& place,
                              const TextMeasure& measure);

/// Of one line, not wider than `most`: the text is cut in the middle, with an ellipsis.
PlacedText fittedText(const QString& text, double most, const TextMeasure& measure);

} // namespace tetra
