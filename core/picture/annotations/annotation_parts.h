// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_layout.h"

namespace tetra {

/// The annotations one by one: how large they are, and what stands where in the place that they were given. Sizes are
/// empty for what has nothing to say.

/// `axis`: barAxisOf() the content, which is worked out once for a layout.
Size colourBarSize(const AnnotationContent& content, const BarAxis& axis, double height, const Size& picture,
                   const TextMeasure& measure);
ColourBarLayout layOutColourBar(const AnnotationContent& content, const BarAxis& axis, const Rectangle& place,
                                const TextMeasure& measure);

Size axesSize(const TextMeasure& measure);
AxesLayout layOutAxes(const AnnotationContent& content, const Rectangle& place, const TextMeasure& measure);

/// For a picture of this size.
Size scaleBarSize(const AnnotationContent& content, const Size& picture, const TextMeasure& measure);
ScaleBarLayout layOutScaleBar(const AnnotationContent& content, const Size& picture, const Rectangle& place,
                              const TextMeasure& measure);

/// On the outline of the box, outside of which all texts stand: they touch neither each other nor `others`. None where
/// the eye is in the box.
std::vector<BoxAxisLayout> layOutBoxAxes(const AnnotationContent& content, const Size& picture,
                                         const std::vector<Rectangle>& others, const TextMeasure& measure);

/// Of one line, not wider than `most`: the text is cut in the middle, with an ellipsis.
PlacedText fittedText(const std::string& text, double most, const TextMeasure& measure);

} // namespace tetra
