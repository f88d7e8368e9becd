// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/lens_painter.h"

#include <tan/base.h>
#include <tan/render.h>

#include <QImage>
#include <QString>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace tetra {

/// The same pixels as Qt's image. O(pixels).
QImage imageOf(const Picture& picture);

struct LensOrder;

/// A picture to save, in the still resolution.
struct PictureOrder {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    Colour background;
    int width = 0;
    int height = 0;
    std::optional<PixelRectangle> part{};             ///< only this part of it is drawn
    std::shared_ptr<const LensOrder> lens{};          ///< drawn over it (scene_pipeline.h)
    std::filesystem::path target{};                   ///< empty: the picture goes to the clipboard
    bool transparent = false;                         ///< without the background
    int samplesPerAxis = 4;                           ///< of a pixel: as many as the viewport takes at rest
    int threads = 0;                                  ///< the most to use; 0: all
    double lineScale = 1;                             ///< of the widths of lines
    LensWriting lensWriting{};                        ///< of what is said in the lens
    int dotsPerInch = 0;                              ///< for printing; 0 says nothing
    std::map<QString, QString> texts{};               ///< what the file says of itself, by PNG keywords
    std::function<Status(Picture& picture)> finish{}; ///< paints over it; called in the worker
};

/// A drawn picture with all else that was ordered; the lens, if there is one, is drawn already. Errors: texts are to be
/// written, and this system has no font.
Result<QImage> finishedPicture(const PictureOrder& order, Picture picture,
                               const std::optional<DrawnLens>& lens = std::nullopt);

/// Writes a PNG file, whole or not at all.
Status writePicture(const QImage& picture, const std::filesystem::path& target);

} // namespace tetra
