// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"
#include "core/picture/drawing/fonts.h"
#include "core/picture/drawing/pixels.h"

#include <QImage>
#include <QLocale>

#include <memory>

namespace tetra {

/// What a locale writes numbers with, without anything between groups of digits.
NumberSigns numberSigns(const QLocale& locale);

/// That of the user: numbers by the locale, words as they are translated (message_text.h).
AnnotationLanguage annotationLanguage();

/// The fonts of the window's family; null if this system has none, or there is no window.
std::shared_ptr<const Fonts> windowFonts();

/// The pixels of an image of the format RGBA8888, to be painted over as long as the image is not copied.
PixelView pixelsOf(QImage& image);

} // namespace tetra
