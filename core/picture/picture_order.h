// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/lens_painter.h"
#include "core/picture/drawing/canvas.h"
#include "core/picture/png_file.h"

#include <tan/base.h>
#include <tan/render.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace tetra {

struct LensOrder;

/// A picture to save, in the still resolution.
struct PictureOrder {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    Colour background;
    int width = 0;
    int height = 0;
    std::optional<PixelRectangle> part{};    ///< only this part of it is drawn
    std::shared_ptr<const LensOrder> lens{}; ///< drawn over it (scene_pipeline.h)
    LensWriting lensWriting{};
    std::filesystem::path target{};             ///< empty: the picture is for its reader alone
    bool transparent = false;                   ///< without the background
    int samplesPerAxis = 4;                     ///< of a pixel: as many as the viewport takes at rest
    int threads = 0;                            ///< the most to use; 0: all
    double lineScale = 1;                       ///< of the widths of lines
    int dotsPerInch = 0;                        ///< for printing; 0 says nothing
    std::map<std::string, std::string> texts{}; ///< what the file says of itself, by PNG keywords
    double unit = 1;                            ///< of what is painted over it, in pixels
    /// Paints over it; called in the worker. Null: nothing.
    std::function<Status(const PixelCanvas& canvas)> over{};
};

/// A drawn picture with all else that was ordered, but for what a target of vectors keeps beside the pixels; the lens,
/// if there is one, is drawn already. Errors: those of paintLens() and of what paints over it.
Result<Picture> finishedPicture(const PictureOrder& order, Picture picture,
                                const std::optional<DrawnLens>& lens = std::nullopt);

/// What the file of such a picture says besides its pixels.
PngFacts pngFacts(const PictureOrder& order);

/// Writes a finished picture to the order's target, in the format that its ending tells; in a PDF file with what is
/// painted over it as lines, shapes and texts. Errors: those of writePicture() and of what paints over it.
Status writeOrdered(const PictureOrder& order, const Picture& finished);

} // namespace tetra
