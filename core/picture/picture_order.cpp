// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/picture_order.h"

#include "core/picture/drawing/vector_drawing.h"
#include "core/picture/picture_file.h"

#include <utility>

namespace tetra {

Result<Picture> finishedPicture(const PictureOrder& order, Picture picture, const std::optional<DrawnLens>& lens)
{
    if (lens)
        if (const Status painted =
                paintLens(pixelsOf(picture), *lens, order.background, order.lineScale, order.lensWriting);
            !painted)
            return painted.error();
    if (order.over && pictureFormatOf(order.target) != PictureFormat::Pdf)
        if (const Status painted = order.over(PixelCanvas(pixelsOf(picture), order.unit)); !painted)
            return painted.error();
    return picture;
}

PngFacts pngFacts(const PictureOrder& order)
{
    return {.transparent = order.transparent, .dotsPerInch = order.dotsPerInch, .texts = order.texts};
}

Status writeOrdered(const PictureOrder& order, const Picture& finished)
{
    if (pictureFormatOf(order.target) != PictureFormat::Pdf)
        return writePicture(finished, order.target, pngFacts(order));
    VectorDrawing drawing;
    if (order.over)
        if (const Status drawn = order.over(PixelCanvas(drawing, finished.width, finished.height, order.unit)); !drawn)
            return drawn;
    return writePdf(finished, {drawing, order.unit}, order.target, pngFacts(order));
}

} // namespace tetra
