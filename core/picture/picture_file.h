// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/vector_drawing.h"

#include <tan/base.h>
#include <tan/picture.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// The formats of files of pictures. Each holds the pixels without loss, but for JPEG, and what the file says of itself
/// as far as there is room: PNG and PDF all of it; TIFF all as its description; JPEG as its comment.
enum class PictureFormat { Png, Tiff, Jpeg, Pdf };

/// By the ending of the name, in whatever letters; none for others.
std::optional<PictureFormat> pictureFormatOf(const std::filesystem::path& file);

bool writesTiff();
bool writesJpeg();
bool writesPdf();

/// Whether a picture can be written there: its ending is known, this build writes that format, and that can be
/// transparent if the picture is. Errors (WrongUsage).
Status checkPictureFormat(const std::filesystem::path& file, bool transparent);

/// What the texts say, in lines "Keyword: text"; without those of one keyword.
std::string textsInLines(const PngFacts& facts, const std::string& without = {});

/// The picture as a TIFF file in memory, packed without loss (Deflate). Errors as of pngOf(), or this build writes
/// none.
Result<std::vector<std::byte>> tiffOf(const Picture& picture, const PngFacts& facts);
/// The picture as a JPEG file in memory, of quality 95, with its colours as fine as its brightness. Errors: those of
/// pngOf(); it is transparent, or has no pixels (WrongUsage); or this build writes none.
Result<std::vector<std::byte>> jpegOf(const Picture& picture, const PngFacts& facts);

/// What lies over a picture as lines, shapes and texts.
struct DrawingOver {
    const VectorDrawing& drawing;
    double unit = 1; ///< in pixels
};

/// Writes a PDF file, whole or not at all: the picture, and over it the drawing. Its page is as large as the picture at
/// so many dots per inch, or 150 if nothing is said. Errors: those of pdfOf(), and of a file that cannot be written.
Status writePdf(const Picture& picture, const DrawingOver& over, const std::filesystem::path& target,
                const PngFacts& facts);

} // namespace tetra
