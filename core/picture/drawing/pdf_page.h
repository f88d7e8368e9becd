// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/vector_drawing.h"

#include <tan/base.h>
#include <tan/render.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tetra {

/// What a PDF file is of besides its picture. Texts are UTF-8; empty ones are left out.
struct PdfFacts {
    double pixelsPerInch = 150;
    double pixelsPerUnit = 1; ///< of the drawing
    bool transparent = false; ///< the picture's pixels are as opaque as they say; else all of them are
    std::string title{};
    std::string subject{};
    std::string creator{};
    std::string keywords{};
};

/// Whether this build writes PDF files.
bool writesPdf();

/// A PDF file in memory, a page as large as the picture, which it shows as it is, without loss, and over it the drawing
/// as lines, shapes and texts that can be selected and searched; the fonts are in the file as far as they are used.
/// O(pixels). Errors (OutOfResource): not enough memory, or this build writes none.
Result<std::vector<std::byte>> pdfOf(const Picture& picture, const VectorDrawing& drawing, const PdfFacts& facts);

} // namespace tetra
