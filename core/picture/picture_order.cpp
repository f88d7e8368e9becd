// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/picture_order.h"

#include <utility>

namespace tetra {

Result<Picture> finishedPicture(const PictureOrder& order, Picture picture, const std::optional<DrawnLens>& lens)
{
    if (lens)
        if (const Status painted =
                paintLens(pixelsOf(picture), *lens, order.background, order.lineScale, order.lensWriting);
            !painted)
            return painted.error();
    if (order.finish)
        if (const Status painted = order.finish(picture); !painted)
            return painted.error();
    return picture;
}

PngFacts pngFacts(const PictureOrder& order)
{
    return {.transparent = order.transparent, .dotsPerInch = order.dotsPerInch, .texts = order.texts};
}

} // namespace tetra
